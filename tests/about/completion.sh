#!/bin/bash
# SPDX-License-Identifier: Apache-2.0
# completion.sh JOUNCE: runs the completion script of each shell as the shell does. bash is always there. If zsh or fish is not
# installed, the test checks the first or last line of its script.
set -u
jounce=$(realpath "$1")
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
ln -s "$jounce" "$scratch/jounce"
export PATH="$scratch:$PATH"
failed=0
expect() { # expect NAME FOUND WANTED
  [ "$2" = "$3" ] || { echo "$1: '$2' instead of '$3'"; failed=1; }
}

jounce completion bash > "$scratch/jounce.bash"
# Prints the words that bash offers for a command line whose last word is at the cursor, and the option of compopt.
in_bash() {
  bash -c '
    compopt() { option="$*"; }  # the builtin works only while a user completes
    source "$0"
    COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
    _jounce "$1" "${*: -1}" "${*: -2:1}"
    echo "${COMPREPLY[*]} ($option)"' "$scratch/jounce.bash" "$@"
}
expect "bash: a verb" "$(in_bash jounce conv)" "convert (+o default)"
expect "bash: the completion is registered" "$(bash -c 'source "$0"; complete -p jounce' "$scratch/jounce.bash")" \
  "complete -F _jounce jounce"
expect "bash: an option" "$(in_bash jounce check --form)" "--format (+o default)"
expect "bash: a value" "$(in_bash jounce check --format gi)" "github gitlab (+o default)"
expect "bash: a value after =" "$(in_bash jounce check --format = sar)" "sarif (+o default)"
expect "bash: all values after =" "$(in_bash jounce stream --until =)" "download arm start (+o default)"
expect "bash: a kind" "$(in_bash jounce new kn)" "knife (+o default)"
expect "bash: a law" "$(in_bash jounce laws sept)" "septic (+o default)"
expect "bash: a command of an axis" "$(in_bash jounce order feeder gear-in-)" "gear-in-pos (+o default)"
expect "bash: a rule" "$(in_bash jounce explain warning/no_)" "warning/no_limits (+o default)"
expect "bash: files" "$(in_bash jounce check '')" " (-o default)"
expect "bash: a file after -o" "$(in_bash jounce design cam.toml -o '')" " (-o default)"
expect "bash: nothing for a number" "$(in_bash jounce check --continuity '')" " (+o default)"
expect "bash: hidden options" "$(in_bash jounce run axis.toml --inject)" " (+o default)"
expect "bash: hidden verbs" "$(in_bash jounce man)" " (+o default)"
expect "bash: a shell" "$(in_bash jounce completion z)" "zsh (+o default)"

jounce completion zsh > "$scratch/_jounce"
if command -v zsh > /dev/null; then
  in_zsh() {
    zsh -fc '
      compdef() { print -r -- "compdef $*" }
      _describe() { print -rl -- "${(@P)2}" }
      _files() { print -r -- files }
      compset() { }
      source "$0"
      words=("$@") CURRENT=$#
      _jounce' "$scratch/_jounce" "$@"
  }
  expect "zsh: a verb" "$(in_zsh jounce conv)" "compdef _jounce jounce
convert:Convert between formats of tables and controllers, and report the error"
  expect "zsh: values after =" "$(in_zsh jounce check --format=gi)" "compdef _jounce jounce
--format=github:
--format=gitlab:"
  expect "zsh: files" "$(in_zsh jounce check '')" "compdef _jounce jounce
files"
fi
expect "zsh: the first line" "$(head -1 "$scratch/_jounce")" "#compdef jounce"
grep -q "__complete" "$scratch/_jounce" || { echo "zsh: the script does not call the program"; failed=1; }

jounce completion fish > "$scratch/jounce.fish"
if command -v fish > /dev/null; then
  export HOME=$scratch
  touch "$scratch/cam.toml"
  in_fish() { (cd "$scratch" && fish -c 'source $argv[1]; complete -C "$argv[2]"' "$scratch/jounce.fish" "$1"); }
  expect "fish: a verb" "$(in_fish 'jounce conv')" "convert	Convert between formats of tables and controllers, and report the error"
  expect "fish: values" "$(in_fish 'jounce check --format gi')" "github
gitlab"
  expect "fish: values after =" "$(in_fish 'jounce check --format=sar')" "--format=sarif"
  expect "fish: files" "$(in_fish 'jounce check ca')" "cam.toml"
  expect "fish: a file after =" "$(in_fish 'jounce design x --output=ca')" "--output=cam.toml"
fi
expect "fish: the last line" "$(tail -1 "$scratch/jounce.fish")" "complete -c jounce -f -a '(__jounce_complete)'"
grep -q "__complete" "$scratch/jounce.fish" || { echo "fish: the script does not call the program"; failed=1; }
exit $failed
