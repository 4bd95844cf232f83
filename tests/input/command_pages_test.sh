#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# The man page and the completion for bash name every command and option of --help, and nothing else.
. "$(dirname "$0")/../support/run.sh"

"$thaw" docs --man >"$work/thaw.1"; expectExit 0 "thaw docs --man"
"$thaw" docs --completion bash >"$work/thaw.bash"; expectExit 0 "thaw docs --completion bash"
sed 's/\\-/-/g; s/\\f[BIR]//g' "$work/thaw.1" >"$work/plain"
# shellcheck source=/dev/null
. "$work/thaw.bash"

# complete WORDS...: completes the last word as a shell does; prints the candidates
complete_words() {
  COMP_WORDS=(thaw "$@") COMP_CWORD=$# COMPREPLY=()
  _thaw
  printf '%s\n' "${COMPREPLY[@]}"
}
# optionsOf [COMMAND]: options in --help
optionsOf() { "$thaw" "$@" --help | sed -n 's/^  \(-[^ {]*\).*/\1/p' | tr ',' '\n'; }
manOptions() {  # manOptions COMMAND: options on the man page
  awk -v start=".SS $1" '/^\.S[SH]/ { on = $0 == start } tagged { print } { tagged = on && /^\.TP/ }' \
    "$work/plain" | sed -n '/^-/{s/ [A-Z].*//;s/, /\n/g;p}'
}
# same WHAT EXPECTED FOUND: the lists have the same words
same() { diff <(sort -u <<<"$2") <(sort -u <<<"$3") >"$work/log" || { fail "$1"; cat "$work/log"; }; }

commands=$("$thaw" --help | sed -n '/^Subcommands:/,$s/^  \([a-z]\+\) .*/\1/p')
[ "$(wc -l <<<"$commands")" -ge 8 ] || fail "--help lists only: $commands"
same "commands of the man page" "$commands" "$(sed -n '/^.SH COMMANDS/,/^.SH EXIT/s/^.SS //p' "$work/plain")"
same "commands of the completion" "$commands
$(optionsOf)" "$(complete_words '')"
for command in $commands; do
  options=$(optionsOf "$command")
  same "options of $command on the man page" "$options" "$(manOptions "$command")"
  same "options of $command in the completion" "$options" "$(complete_words "$command" -)"
done
same "values of an option" $'mesh\nwire\ndiscs\naxes' "$(complete_words render --look '')"
same "arguments are files" '' "$(complete_words run '')"
if command -v groff >/dev/null; then
  groff -man -Tascii -ww -z "$work/thaw.1" 2>"$work/warnings"
  [ ! -s "$work/warnings" ] || { fail "groff warns of the man page"; head -n 5 "$work/warnings"; }
fi

"$thaw" docs --completion fish >"$work/log" 2>&1; expectExit 2 "a shell without a completion"
"$thaw" docs --man --completion bash >"$work/log" 2>&1; expectExit 2 "two pages at once"
finish
