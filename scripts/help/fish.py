"""Completion for fish, with the texts of commands and options beside them."""
from help.tree import value_of

HEAD = """# fish completion of tolman; generated from the program's help by scripts/generate-help
"""

FUNCTIONS = r"""
# Is COMMAND the one that is typed, with COUNT arguments so far (any number of them, or with `more` at least
# COUNT)?
function __tolman_at --argument-names command count more
    set -l called tolman
    set -l given 0
    set -l is_value 0
    for word in (commandline -opc)[2..-1]
        if test $is_value = 1
            set is_value 0
        else if string match -q -- '-*' $word
            contains -- "$called $word" $__tolman_valued; and set is_value 1
        else if contains -- "$called $word" $__tolman_commands
            set called "$called $word"
            set given 0
        else
            set given (math $given + 1)
        end
    end
    test "$called" = "$command"; or return 1
    test -z "$count"; and return 0
    test $given = $count; or test -n "$more" -a $given -gt $count
end

# The plugins that are found, all or those of one role, with their summaries.
function __tolman_plugins --argument-names role
    for line in (tolman plugins list 2>/dev/null)
        set -l fields (string split -n ' ' -- $line)
        test $fields[1] = -; and continue
        test -z "$role"; or test $fields[1] = "$role"; or continue
        printf '%s\t%s\n' $fields[2] "$fields[4..-1]"
    end
end

complete -c tolman -f
"""


def quoted(text):
    """As a word of the shell."""
    return "'" + text.replace("\\", "\\\\").replace("'", "\\'") + "'"


def flags_of(value, configurations):
    """What `complete` is told of a value of this kind."""
    kind, _, rest = value.partition(" ")
    return {
        "choice": f"-x -a {quoted(rest)}",
        "configuration": f"-x -a {quoted(' '.join(configurations) + ' (__fish_complete_suffix .yaml)')}",
        "file": "-r -F",
        "library": "-x -a '(__fish_complete_suffix .so)'",
        "directory": "-x -a '(__fish_complete_directories)'",
        "plugin": f"-x -a '(__tolman_plugins {rest})'",
    }.get(kind, "-x")


def lines_of(command, configurations):
    """The lines that tell what may follow one command."""
    def line(condition, rest):
        return f"complete -c tolman -n {quoted('__tolman_at ' + condition)} {rest}"

    here = f'"{command.words}"'
    lines = [line(f"{here} 0", f"-a {sub.name} -d {quoted(sub.text)}") for sub in command.commands]
    for option in command.options:
        names = " ".join(f"-l {name[2:]}" if name.startswith("--") else f"-s {name[1:]}" for name in option["names"])
        value = f" {flags_of(value_of(option), configurations)}" if "value" in option else ""
        lines.append(line(here, f"{names} -d {quoted(option['text'])}{value}"))
    for place, part in enumerate(command.positionals):
        more = " more" if part["repeated"] else ""
        # Without an option -r and -x do not apply.
        flags = flags_of(value_of(part), configurations).replace("-x", "").replace("-r", "").strip()
        if flags:
            lines.append(line(f"{here} {place}{more}", flags))
    return lines


def script(commands, configurations):
    """The whole script."""
    valued = [f"{command.words} {name}" for command in commands for option in command.options if "value" in option
              for name in option["names"]]
    lines = ["\nset -g __tolman_commands " + " ".join(quoted(command.words) for command in commands[1:]),
             "set -g __tolman_valued " + " ".join(quoted(words) for words in valued)]
    rest = [line for command in commands for line in lines_of(command, configurations)]
    return HEAD + "\n".join(lines) + "\n" + FUNCTIONS + "\n".join(rest) + "\n"
