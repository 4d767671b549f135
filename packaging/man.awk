# Manual pages, from the facts about a program: one of the program, and one of each command. Needs
# the variables `folder`, where the pages go, and `version`.
function roff(text) {
    gsub(/\\/, "\\e", text)
    gsub(/-/, "\\-", text)
    gsub(/'/, "\\(aq", text)
    gsub(/`/, "\\(ga", text)
    gsub(/\^/, "\\(ha", text)
    gsub(/~/, "\\(ti", text)
    sub(/^\./, "\\\\\\&.", text)
    return text
}

function bold(text) {
    return "\\fB" roff(text) "\\fR"
}

function lower_first(text) {
    return tolower(substr(text, 1, 1)) substr(text, 2)
}

# The first sentence, without what ends it.
function first_sentence(text) {
    sub(/[.?!]( .*)?$/, "", text)
    return text
}

function synopsis(c,    text, i, operand) {
    if (c in usage) return usage[c]
    text = "[OPTIONS]"
    for (i = 1; i <= items[c]; ++i) {
        if (kind[c, i] != "operand") continue
        operand = names[c, i]
        text = text " " (value[c, i] ~ /REQUIRED/ ? operand : "[" operand "]")
    }
    return text (c == 0 && commands ? " COMMAND" : "")
}

# What else the options of the same line have to say: `Needs: ...`, `Excludes: ...`.
function relations(value) {
    return match(value, /(Needs|Excludes):/) ? " " substr(value, RSTART) : ""
}

function without_relations(value) {
    sub(/ *(Needs|Excludes):.*/, "", value)
    return value == "" ? "" : " " value
}

function print_items(c, wanted, heading,    i, head, begun) {
    for (i = 1; i <= items[c]; ++i) {
        if (kind[c, i] != wanted || description[c, i] == "") continue
        if (!begun++) print ".SH " heading > page
        head = names[c, i]
        gsub(",", ", ", head)
        print ".TP" > page
        print bold(head) roff(without_relations(value[c, i])) > page
        print roff(description[c, i] "." relations(value[c, i])) > page
    }
}

function print_commands(    c) {
    print ".SH COMMANDS" > page
    for (c = 1; c <= commands; ++c) {
        print ".TP" > page
        print bold(program "-" command_name[c]) "(1)" > page
        print roff(summary[c]) > page
    }
}

# The heading that begins at this line of a help text; empty if none does.
function heading_of(line, begun) {
    if (line ~ /^[A-Z][A-Za-z ]*:$/) return toupper(substr(line, 1, length(line) - 1))
    if (line ~ /^Exit status: /) return "EXIT STATUS"
    if (begun || line == "") return ""
    return line ~ /^ / ? "EXAMPLES" : "NOTES"
}

# Lines of a help text: headings, examples, which are indented, and prose.
function print_text(c,    i, line, heading, begun, gap, verbatim) {
    for (i = 1; i <= lines[c]; ++i) {
        line = text[c, i]
        if (verbatim && line !~ /^ /) {
            print ".fi" > page
            verbatim = 0
        }
        heading = heading_of(line, begun)
        if (heading != "") {
            print ".SH " heading > page
            begun = 1
            gap = 0
            if (line ~ /:$/) continue
            sub(/^Exit status: /, "", line)
        }
        if (line == "") {
            gap = begun
            continue
        }
        if (gap) print ".PP" > page
        gap = 0
        if (line ~ /^ / && !verbatim++) print ".nf" > page
        print roff(line) > page
    }
    if (verbatim) print ".fi" > page
}

function print_see_also(c,    other) {
    print ".SH SEE ALSO" > page
    other = program == "plcheck" ? "plprove" : "plcheck"
    print (c > 0 ? bold(program) "(1), " : "") bold(other) "(1)" > page
}

function print_page(c,    name) {
    name = program (c == 0 ? "" : "-" command_name[c])
    page = folder "/" name ".1"
    print ".TH " toupper(roff(name)) " 1 \"\" \"" program " " version "\" \"Point\\-line certificates\"" > page
    print ".SH NAME" > page
    print roff(name) " \\- " roff(lower_first(first_sentence(summary[c]))) > page
    print ".SH SYNOPSIS" > page
    print bold(program (c == 0 ? "" : " " command_name[c])) " " roff(synopsis(c)) > page
    print ".SH DESCRIPTION" > page
    print roff(summary[c]) (summary[c] ~ /[.?!]$/ ? "" : ".") > page
    print_items(c, "operand", "ARGUMENTS")
    print_items(c, "option", "OPTIONS")
    if (c == 0 && commands) print_commands()
    print_text(c)
    print_see_also(c)
    close(page)
}

END {
    for (c = 0; c <= commands; ++c)
        print_page(c)
}
