#compdef jounce
# Completion of jounce in zsh. The program itself finds the words: jounce __complete WORD...
_jounce() {
  local line
  local -a found
  local -i files=0
  for line in "${(@f)$("${words[1]/#\~/$HOME}" __complete "${(@)words[2,CURRENT]}" 2> /dev/null)}"; do
    case $line in
    :files) files=1 ;;
    ?*) found+=("${${line%%$'\t'*}//:/\\:}:${line#*$'\t'}") ;;
    esac
  done
  (( $#found )) && _describe jounce found
  if (( files )); then
    compset -P '--*='
    _files
  fi
}
if [[ $funcstack[1] == _jounce ]]; then _jounce "$@"; else compdef _jounce jounce; fi
