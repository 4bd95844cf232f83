# SPDX-License-Identifier: Apache-2.0
# Shared by the tests of the page: skips where there is no browser, and runs cases of browser_test.mjs on
# $address.
. "$(dirname "${BASH_SOURCE[0]}")/../support/run.sh"
skip() { echo "skipped: $*"; exit 77; }
MODULES=$(sed -n 's/^THAW_VIEW_MODULES:PATH=//p' "$build/CMakeCache.txt")
CHROMIUM=$(command -v chromium || command -v chromium-browser || command -v google-chrome)
export MODULES CHROMIUM
get="scripts/view --test installs it"
command -v node >/dev/null || skip "node is not installed ($get)"
[ -n "$CHROMIUM" ] || skip "chromium is not installed ($get)"
[ -d "$MODULES/playwright-core" ] || skip "playwright-core is not in $MODULES ($get)"
inBrowser() {  # inBrowser CASE [ARGUMENT]: a case of browser_test.mjs
  timeout 900 node "$source_dir/tests/view/browser_test.mjs" "$1" "$address" "${@:2}" >"$work/log" 2>&1 ||
    { fail "$1 $address"; tail -n 30 "$work/log"; }
}
simulate() { "$thaw" run "$@" >"$work/log" 2>&1; expectExit 0 "run $1"; }
