# Completion of jounce in bash. The program itself finds the words: jounce __complete WORD...
_jounce() {
  local line files=no
  COMPREPLY=()
  while IFS= read -r line; do
    if [[ $line == :files ]]; then files=yes; else COMPREPLY+=("${line%%$'\t'*}"); fi
  done < <("${1/#\~/$HOME}" __complete "${COMP_WORDS[@]:1:COMP_CWORD}" 2> /dev/null)
  if [[ $files == yes ]]; then compopt -o default; else compopt +o default; fi
}
complete -F _jounce jounce
