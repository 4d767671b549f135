# Turns what `plcheck --help` prints into the facts that prover/cli/describe.h lists. An option is a
# line that begins, after blanks, with dashes; its description begins after two blanks, and goes on
# in lines that are indented as deep. Two kinds of lines are added: `usage` and what follows the
# program's name in a call of it, and `item N` where the help has the Nth option.
BEGIN {
    print "program\tplcheck\tReplays certificates of point-line problems, and says what they prove."
}

function end_option() {
    if (names == "") return
    options[++count] = "option\t" names "\t" value "\t" description
    lines[++line_count] = "item\t" count
    names = ""
}

function begin_option(line,    head, gap, first_blank) {
    match(line, /^ +/)
    indentation = RLENGTH
    line = substr(line, indentation + 1)
    gap = match(line, /  +/)
    head = gap ? substr(line, 1, gap - 1) : line
    description = gap ? substr(line, gap + RLENGTH) : ""
    column = gap ? indentation + gap + RLENGTH - 1 : 0
    gsub(/, */, ",", head)
    first_blank = index(head, " ")
    names = first_blank ? substr(head, 1, first_blank - 1) : head
    value = first_blank ? substr(head, first_blank + 1) : ""
}

function indentation_of(line) {
    match(line, /^ */)
    return RLENGTH
}

tolower($1) == "usage:" {
    sub(/^[^:]*: *plcheck */, "")
    print "usage\t" $0
    print "operand\tFILE\tFILE\t"
    next
}

/^ +-/ {
    end_option()
    begin_option($0)
    next
}

names != "" && /^  / && (indentation_of($0) == column || column == 0) {
    column = indentation_of($0)
    sub(/^ +/, "")
    description = description (description == "" ? "" : " ") $0
    next
}

{
    end_option()
    lines[++line_count] = "text\t" $0
}

END {
    end_option()
    for (i = 1; i <= count; ++i) print options[i]
    for (i = 1; i <= line_count; ++i) print lines[i]
}
