# Completion for zsh, from the facts about a program.
function quoted(text) {
    gsub(/'/, "'\\''", text)
    return "'" text "'"
}

# A text where _arguments gives brackets and colons a meaning.
function escaped(text) {
    gsub(/\\/, "\\\\", text)
    gsub(/\[/, "\\[", text)
    gsub(/\]/, "\\]", text)
    gsub(/:/, "\\:", text)
    return text
}

function action(kind, value, description,    what) {
    what = completes(kind, value, description)
    if (what == "words") return ":value:(" choices(value, description) ")"
    if (what == "folder") return ":folder:_files -/"
    if (what == "file") return ":file:_files"
    return what == "flag" ? "" : ":value: "
}

function print_item(c, i,    list, count, j, exclusive, rest) {
    if (kind[c, i] == "operand") {
        print "        " quoted("*" action("operand", value[c, i], "")) " \\"
        return
    }
    exclusive = names[c, i]
    gsub(",", " ", exclusive)
    rest = "[" escaped(description[c, i]) "]" action("option", value[c, i], description[c, i])
    count = split(names[c, i], list, ",")
    for (j = 1; j <= count; ++j)
        print "        " quoted("(" exclusive ")" list[j] rest) " \\"
}

function print_items(c,    i) {
    for (i = 1; i <= items[c]; ++i)
        print_item(c, i)
}

END {
    print "#compdef " program
    print "# Completion of " program " for zsh, made from its help."
    print "_" program "() {"
    if (!commands) {
        print "    _arguments -S \\"
        print_items(0)
        print "        && return"
    } else {
        print "    local state line"
        print "    typeset -A opt_args"
        print "    _arguments -C \\"
        print_items(0)
        print "        '1:command:->command' '*::argument:->argument' && return"
        print "    if [[ $state == command ]]; then"
        print "        local -a commands=("
        for (c = 1; c <= commands; ++c)
            print "            " quoted(command_name[c] ":" escaped(summary[c]))
        print "        )"
        print "        _describe command commands"
        print "        return"
        print "    fi"
        print "    case $line[1] in"
        for (c = 1; c <= commands; ++c) {
            print "    " command_name[c] ")"
            print "        _arguments \\"
            print_items(c)
            print "        ;;"
        }
        print "    esac"
    }
    print "}"
    print "_" program " \"$@\""
}
