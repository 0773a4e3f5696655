# bash completion of tolman: commands and options from the program's own help, files for everything else.
_tolman() {
  local current=${COMP_WORDS[COMP_CWORD]} word commands=()
  for word in "${COMP_WORDS[@]:1:COMP_CWORD-1}"; do
    [[ $word == -* || $word == */* || $word == *.* || ${#commands[@]} -ge 2 ]] || commands+=("$word")
  done
  local help=$(tolman "${commands[@]}" --help 2>/dev/null || tolman "${commands[0]}" --help 2>/dev/null)
  local words=$(grep -oE -- '(^| |,)--[a-z-]+' <<<"$help" | tr -d ', '; sed -n '/^Subcommands:/,/^[A-Z]/s/^  \([a-z]*\) .*/\1/p' <<<"$help")
  local shipped=("$(dirname "$(readlink -f "$(command -v tolman)")")"/../share/tolman/configs/*.yaml)
  words+=" $(basename -as .yaml "${shipped[@]}")"
  COMPREPLY=($(compgen -W "$words" -- "$current"))
}
complete -o default -F _tolman tolman
