"""Completion for bash; works with and without the package bash-completion."""
import shlex

from help.tree import value_of

HEAD = r"""# bash completion of tolman; generated from the program's help by scripts/generate-help
"""

FUNCTIONS = r"""
# Adds the words that begin as the current one does.
_tolman_words() {
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -W "$1" -- "$current")
}

# Adds files whose names end with $1, and folders.
_tolman_files() {
  compopt -o filenames 2>/dev/null
  mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(
    [[ -z $1 ]] || compgen -d -- "$current"
    compgen -f -X "!*$1" -- "$current")
}

# Adds the plugins that are found, all or those of one role.
_tolman_plugins() {
  local role id rest ids=
  while read -r role id rest; do
    [[ $role == - || ( -n $1 && $role != "$1" ) ]] || ids+=" $id"
  done < <("${COMP_WORDS[0]}" plugins list 2>/dev/null)
  _tolman_words "$ids"
}

# Adds what can be a value of this kind.
_tolman_value() {
  case $1 in
    'choice '*) _tolman_words "${1#choice }" ;;
    configuration) _tolman_words "$_tolman_configurations"; _tolman_files .yaml ;;
    file) _tolman_files '' ;;
    library) _tolman_files .so ;;
    directory)
      compopt -o filenames 2>/dev/null
      mapfile -t COMPREPLY < <(compgen -d -- "$current") ;;
    plugin) _tolman_plugins '' ;;
    'plugin '*) _tolman_plugins "${1#plugin }" ;;
  esac
}

_tolman() {
  local current=${COMP_WORDS[COMP_CWORD]} called=tolman kind= count=0 word
  local commands= options= positionals=() repeated=
  local -A values=()
  COMPREPLY=()
  _tolman_load "$called"
  # A value behind '=' is a word of its own.
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    if [[ $word == = ]]; then
      [[ -n $kind ]] || kind=file
    elif [[ -n $kind ]]; then
      kind=
    elif [[ $word == -* ]]; then
      kind=${values[$word]-}
    elif [[ " $commands " == *" $word "* ]]; then
      called+=" $word" count=0
      _tolman_load "$called"
    else
      count=$((count + 1))
    fi
  done
  if [[ $current == = ]]; then
    current= kind=${kind:-file}
    [[ $kind != setting ]] || kind=file
  fi
  if [[ -n $kind ]]; then
    _tolman_value "$kind"
  elif [[ $current == -* ]]; then
    _tolman_words "$options"
  else
    [[ $count -gt 0 ]] || _tolman_words "$commands"
    [[ -z $repeated || $count -lt ${#positionals[@]} ]] || count=$((${#positionals[@]} - 1))
    _tolman_value "${positionals[count]-}"
  fi
}

complete -F _tolman tolman
"""


def branch(command):
    """The lines that tell what may follow one command."""
    lines = [f"    {shlex.quote(command.words)})"]
    if command.commands:
        lines.append(f"      commands='{' '.join(sub.name for sub in command.commands)}'")
    names = [name for option in command.options for name in option["names"]]
    if names:
        lines.append(f"      options='{' '.join(names)}'")
    values = [f"[{name}]={shlex.quote(value_of(option))}"
              for option in command.options if "value" in option for name in option["names"]]
    if values:
        lines.append(f"      values=({' '.join(values)})")
    if command.positionals:
        lines.append(f"      positionals=({' '.join(shlex.quote(value_of(part)) for part in command.positionals)})")
        if command.positionals[-1]["repeated"]:
            lines.append("      repeated=1")
    return lines + ["      ;;"]


def script(commands, configurations):
    """The whole script."""
    lines = [f"\n_tolman_configurations='{' '.join(configurations)}'\n",
             "# Sets what may follow a command.",
             "_tolman_load() {",
             "  commands= options= positionals=() repeated= values=()",
             "  case $1 in"]
    for command in commands:
        lines += branch(command)
    return HEAD + "\n".join(lines + ["  esac", "}"]) + "\n" + FUNCTIONS
