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

function print_item(c, i,    head) {
    head = names[c, i]
    gsub(",", ", ", head)
    print ".TP" > page
    print bold(head) roff(without_relations(value[c, i])) > page
    print roff(description[c, i] "." relations(value[c, i])) > page
}

function print_items(c, wanted, heading,    i, begun) {
    for (i = 1; i <= items[c]; ++i) {
        if (kind[c, i] != wanted || description[c, i] == "") continue
        if (!begun++) print ".SH " heading > page
        print_item(c, i)
    }
}

# The number of the Nth option among the items of a command.
function option_number(c, n,    i) {
    for (i = 1; i <= items[c]; ++i)
        if (kind[c, i] == "option" && --n == 0) return i
    return 0
}

function print_commands(    c) {
    print ".SH COMMANDS" > page
    for (c = 1; c <= commands; ++c) {
        print ".TP" > page
        print bold(program "-" command_name[c]) "(1)" > page
        print roff(summary[c]) > page
    }
}

# Whether the paragraph that begins at a line of the text ends where the text has an option.
function leads_to_option(c, i) {
    while (i <= lines[c] && text[c, i] != "") ++i
    return (c, i) in item_at
}

function is_heading(line) {
    return line ~ /^[A-Z][A-Za-z ]*:$/
}

# The section that a line of the text belongs to, after one of the section `now`.
function section_of(c, i, now,    line) {
    line = text[c, i]
    if ((c, i) in item_at) return "OPTIONS"
    if (is_heading(line)) return toupper(substr(line, 1, length(line) - 1))
    if (line ~ /^Exit status: /) return "EXIT STATUS"
    if (line == "" || (i > 1 && text[c, i - 1] != "")) return now
    if (line ~ /^ /) return now == "" ? "EXAMPLES" : now
    return leads_to_option(c, i) ? "OPTIONS" : "NOTES"
}

# Lines of a help text: headings, examples, which are indented, options, and prose.
function print_text(c,    i, line, section, before, gap, verbatim) {
    for (i = 1; i <= lines[c]; ++i) {
        line = text[c, i]
        if (verbatim && line !~ /^ /) {
            print ".fi" > page
            verbatim = 0
        }
        before = section
        section = section_of(c, i, section)
        if (section != before) {
            print ".SH " section > page
            gap = 0
        }
        if ((c, i) in item_at) {
            print_item(c, option_number(c, item_at[c, i]))
            gap = 1
        } else if (line == "") {
            gap = 1
        } else if (!is_heading(line)) {
            sub(/^Exit status: /, "", line)
            if (gap) print ".PP" > page
            gap = 0
            if (line ~ /^ / && !verbatim++) print ".nf" > page
            print roff(line) > page
        }
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
    if (!(c in usage)) print_items(c, "option", "OPTIONS") # else the text has them in their places
    if (c == 0 && commands) print_commands()
    print_text(c)
    print_see_also(c)
    close(page)
}

END {
    for (c = 0; c <= commands; ++c)
        print_page(c)
}
