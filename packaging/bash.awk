# Completion for bash, from the facts about a program.
function list_options(c,    i, list) {
    list = ""
    for (i = 1; i <= items[c]; ++i)
        if (kind[c, i] == "option") list = list " " names[c, i]
    gsub(",", " ", list)
    return substr(list, 2)
}

function operand_of(c,    i) {
    for (i = 1; i <= items[c]; ++i)
        if (kind[c, i] == "operand") return completes("operand", value[c, i], "")
    return "none"
}

# A branch for each option with a value, and one for what has no option before it.
function print_branches(c,    i, j, list, count, what) {
    for (i = 1; i <= items[c]; ++i) {
        what = completes(kind[c, i], value[c, i], description[c, i])
        if (kind[c, i] != "option" || what == "flag") continue
        count = split(names[c, i], list, ",")
        for (j = 1; j <= count; ++j)
            print_branch("'" command_name[c] " " list[j] "'", what, choices(value[c, i], description[c, i]))
    }
    if (c == 0 && commands)
        print_branch("' '*", "words", list_commands())
    else
        print_branch("'" command_name[c] " '*", operand_of(c), "")
}

function print_branch(pattern, what, words) {
    print "    " pattern ") kind=" what " words='" words "' ;;"
}

function list_commands(    c, list) {
    list = ""
    for (c = 1; c <= commands; ++c)
        list = list (list == "" ? "" : " ") command_name[c]
    return list
}

END {
    print "# Completion of " program " for bash, made from its help."
    print "_" program "() {"
    print "    local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD - 1]}"
    print "    local command= options= kind= words="
    if (commands) print "    if ((COMP_CWORD > 1)); then command=${COMP_WORDS[1]}; fi"
    print "    case \"$command\" in"
    for (c = 0; c <= commands; ++c)
        printf "    '%s') options='%s' ;;\n", command_name[c], list_options(c)
    print "    esac"
    print "    case \"$command $before\" in"
    for (c = 0; c <= commands; ++c)
        print_branches(c)
    print "    esac"
    print "    if [[ $word == -* ]]; then kind=words words=$options; fi"
    print "    case \"$kind\" in"
    print "    words) mapfile -t COMPREPLY < <(compgen -W \"$words\" -- \"$word\") ;;"
    print "    file) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -f -- \"$word\") ;;"
    print "    folder) compopt -o filenames; mapfile -t COMPREPLY < <(compgen -d -- \"$word\") ;;"
    print "    *) COMPREPLY=() ;;"
    print "    esac"
    print "}"
    print "complete -F _" program " " program
}
