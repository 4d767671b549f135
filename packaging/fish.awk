# Completion for fish, from the facts about a program.
function quoted(text) {
    gsub(/\\/, "\\\\", text)
    gsub(/'/, "\\'", text)
    return "'" text "'"
}

# Whether a command line is inside the command (0: before any).
function condition(c) {
    if (commands == 0) return ""
    return c == 0 ? " -n __fish_use_subcommand" \
                  : " -n " quoted("__fish_seen_subcommand_from " command_name[c])
}

function print_option(c, i,    list, count, j, what, line) {
    line = "complete -c " program condition(c)
    count = split(names[c, i], list, ",")
    for (j = 1; j <= count; ++j)
        line = line (list[j] ~ /^--/ ? " -l " substr(list[j], 3) : " -s " substr(list[j], 2))
    what = completes("option", value[c, i], description[c, i])
    if (what == "words") line = line " -x -a " quoted(choices(value[c, i], description[c, i]))
    if (what == "folder") line = line " -x -a '(__fish_complete_directories)'"
    if (what == "file") line = line " -r -F"
    if (what == "none") line = line " -x"
    print line " -d " quoted(description[c, i])
}

END {
    print "# Completion of " program " for fish, made from its help."
    if (commands) print "complete -c " program " -f"
    for (c = 1; c <= commands; ++c)
        print "complete -c " program condition(0) " -a " command_name[c] " -d " quoted(summary[c])
    for (c = 0; c <= commands; ++c)
        for (i = 1; i <= items[c]; ++i) {
            if (kind[c, i] == "option") print_option(c, i)
            else if (completes("operand", value[c, i], "") == "file" && commands)
                print "complete -c " program condition(c) " -F"
        }
}
