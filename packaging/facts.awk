# Reads the facts about a program (prover/cli/describe.h); what follows writes them in its own way,
# in a rule END. Command 0 is the program itself.
BEGIN {
    FS = "\t"
}

$1 == "program" {
    program = $2
    command_name[0] = ""
    summary[0] = $3
    commands = 0
}

$1 == "command" {
    command_name[++commands] = $2
    summary[commands] = $3
}

$1 == "usage" { usage[commands] = $2 }

$1 == "option" || $1 == "operand" {
    i = ++items[commands]
    kind[commands, i] = $1
    names[commands, i] = $2
    value[commands, i] = $3
    description[commands, i] = $4
}

$1 == "text" {
    text[commands, ++lines[commands]] = $2
}

# Where the text has an option: the Nth of the command (item_at), counted without its operands.
$1 == "item" {
    text[commands, ++lines[commands]] = ""
    item_at[commands, lines[commands]] = $2
}

# The words that the value may be, separated by blanks; empty if it is not one of a few words. The
# value lists them, `{a,b}` or `a|b`, or the description does: `a, b or c`.
function choices(value, description) {
    if (match(value, /\{[^}]*\}/)) {
        value = substr(value, RSTART + 1, RLENGTH - 2)
        gsub(",", " ", value)
        return value
    }
    if (match(value, /^[a-z-]+(\|[a-z-]+)+/)) {
        value = substr(value, RSTART, RLENGTH)
        gsub(/\|/, " ", value)
        return value
    }
    if (value != "" && description ~ /^[a-z-]+(, [a-z-]+)* or [a-z-]+$/) {
        gsub(/,| or/, "", description)
        return description
    }
    return ""
}

# What the value is, for a shell to complete: `words`, `folder`, `file`, `none` (nothing that a shell
# knows) or `flag` (the option takes no value).
function completes(kind, value, description) {
    sub(/ *(Needs|Excludes):.*/, "", value)
    if (kind == "option" && value == "") return "flag"
    if (choices(value, description) != "") return "words"
    if (value ~ /^DIR/) return "folder"
    if (value ~ /^(FILE|REPORT)/) return "file"
    if (kind == "option" && value ~ /^TEXT/) return "file"
    return "none"
}
