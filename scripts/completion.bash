# bash completion of tolman: commands and options from the program's own help, names of shipped configurations, files.
_tolman() {
  local current=${COMP_WORDS[COMP_CWORD]} word help words configs commands=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    [[ $word == -* || $word == */* || $word == *.* || ${#commands[@]} -ge 2 ]] || commands+=("$word")
  done
  help=$(tolman "${commands[@]}" --help 2>/dev/null || tolman "${commands[0]}" --help 2>/dev/null)
  words=$(sed -n 's/^ *\(-[a-z],\)\?\(--[a-z-]*\).*/\2/p; /^Subcommands:/,/^[A-Z]/s/^  \([a-z]*\) .*/\1/p' <<<"$help")
  configs=$(dirname "$(readlink -f "$(command -v tolman)")")/../share/tolman/configs
  words+=" $(cd "$configs" 2>/dev/null && printf '%s ' *.yaml | sed 's/\.yaml//g')"
  mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
}
complete -o default -F _tolman tolman
