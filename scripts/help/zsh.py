"""Completion for zsh, with the texts of commands and options beside them."""
from help.tree import value_of

HEAD = """#compdef tolman
# zsh completion of tolman; generated from the program's help by scripts/generate-help
"""

FUNCTIONS = r"""
# Offers the plugins that are found, all or those of one role.
_tolman_plugins() {
  local line
  local -a fields plugins
  for line in ${(f)"$($words[1] plugins list 2>/dev/null)"}; do
    fields=(${=line})
    [[ $fields[1] == - || ( -n $1 && $fields[1] != $1 ) ]] || plugins+=("$fields[2]:$fields[4,-1]")
  done
  _describe -t plugins plugin plugins
}

# Offers what can be a value of this kind.
_tolman_value() {
  local -a choices
  case $1 in
    'choice '*) choices=(${=1#choice }); _describe -t choices value choices ;;
    configuration)
      choices=($tolman_configurations)
      _describe -t configurations 'shipped configuration' choices
      _files -g '*.yaml' ;;
    file) _files ;;
    library) _files -g '*.so' ;;
    directory) _files -/ ;;
    plugin) _tolman_plugins '' ;;
    'plugin '*) _tolman_plugins ${1#plugin } ;;
    setting) if compset -P 1 '*='; then _files; else _message 'name=value'; fi ;;
    *) _message value ;;
  esac
}

_tolman() {
  local called=tolman kind= word
  local -i count=0 repeated=0
  local -a commands options positionals
  local -A values
  _tolman_load $called
  for word in "${(@)words[2,CURRENT-1]}"; do
    if [[ -n $kind ]]; then
      kind=
    elif [[ $word == -* ]]; then
      kind=${values[$word]-}
    elif (( ${commands[(I)$word:*]} )); then
      called+=" $word" count=0
      _tolman_load $called
    else
      count+=1
    fi
  done
  if [[ -n $kind ]]; then
    _tolman_value $kind
  elif [[ $PREFIX == --*=* ]]; then
    kind=${values[${PREFIX%%=*}]-}
    compset -P 1 '*='
    _tolman_value $kind
  elif [[ $PREFIX == -* ]]; then
    _describe -o -t options option options
  else
    (( count > 0 || ! $#commands )) || _describe -t commands command commands
    (( ! repeated || count < $#positionals )) || count=$(($#positionals - 1))
    (( count >= $#positionals )) || _tolman_value $positionals[count+1]
  fi
}

_tolman "$@"
"""


def quoted(text):
    """As a word of the shell."""
    return "'" + text.replace("'", "'\\''") + "'"


def described(name, text):
    """A name with its text, for _describe; a colon in the name would end it."""
    return quoted(name.replace(":", "\\:") + ":" + text)


def branch(command):
    """The lines that tell what may follow one command."""
    lines = [f"    {quoted(command.words)})"]
    if command.commands:
        lines.append("      commands=(" + "\n        ".join(described(sub.name, sub.text) for sub in command.commands) + ")")
    options = [described(name, option["text"]) for option in command.options for name in option["names"]]
    if options:
        lines.append("      options=(" + "\n        ".join(options) + ")")
    values = [f"{name} {quoted(value_of(option))}"
              for option in command.options if "value" in option for name in option["names"]]
    if values:
        lines.append("      values=(" + "\n        ".join(values) + ")")
    if command.positionals:
        lines.append(f"      positionals=({' '.join(quoted(value_of(part)) for part in command.positionals)})")
        if command.positionals[-1]["repeated"]:
            lines.append("      repeated=1")
    return lines + ["      ;;"]


def script(commands, configurations):
    """The whole script."""
    lines = [f"\nlocal -a tolman_configurations=({' '.join(configurations)})\n",
             "# Sets what may follow a command.",
             "_tolman_load() {",
             "  commands=() options=() positionals=() repeated=0 values=()",
             "  case $1 in"]
    for command in commands:
        lines += branch(command)
    return HEAD + "\n".join(lines + ["  esac", "}"]) + "\n" + FUNCTIONS
