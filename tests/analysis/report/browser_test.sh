#!/usr/bin/env bash
# browser_test.sh POWDERLINK CASES FOLDER: opens a report in a headless browser and asks its DOM:
# all figures are there and have a size, no id is given twice, no reference leads nowhere, marks carry
# their values as titles, nothing was requested, and what users wrote is text, not markup.
set -euo pipefail
program=$1
cases=$2
folder=$3
limit_s=100
fail() {
  echo "report in a browser: $*" >&2
  exit 1
}
command -v chromium >/dev/null || fail "chromium is not in PATH; scripts/setup.sh installs it"
rm -rf -- "$folder"
mkdir -p "$folder"
cd "$folder"
# Two studies of one table, their names chosen to break markup and gnuplot's quoting.
cp "$cases/zafar2014/zafar2014_drop_test.csv" .
sed "s|^name = .*|name = '<script>document.title=1</script> \"a\" \& b_{2}'|" \
  "$cases/zafar2014/study.toml" >first.toml
sed -e 's|^name = .*|name = "it'"'"'s stopped"|' -e 's|^effects = .*|effects = ["finite_stop_pulse"]|' \
  "$cases/zafar2014/study.toml" >second.toml
timeout "$limit_s" "$program" report first.toml second.toml --diagnose-first -o report.html >out.txt

# The page forbids all requests and scripts; the copy admits the one that looks at it.
grep -q "default-src 'none'" report.html || fail "the page does not forbid requests"
sed "s/default-src 'none'/default-src 'none'; script-src 'unsafe-inline'/" report.html >looked_at.html
cat >>looked_at.html <<'JS'
<script>
addEventListener("load", () => {
  const all = (selector) => [...document.querySelectorAll(selector)];
  const ids = all("[id]").map((e) => e.id);
  const links = all("use").map((e) => e.getAttribute("xlink:href"))
    .concat(all("a[href^='#']").map((e) => e.getAttribute("href")));
  const answer = {
    figures: all("figure").length,
    empty: all("figure").filter((f) => f.querySelector("svg").getBoundingClientRect().height < 100).length,
    unlabelled: all("figure div[role=img]").filter((e) => !e.getAttribute("aria-label")).length,
    twice: ids.length - new Set(ids).size,
    dangling: links.filter((l) => !document.getElementById(l.slice(1))).length,
    requests: performance.getEntriesByType("resource").length,
    scripts: all("script").length,
    title: document.title,
    wide: document.documentElement.scrollWidth > innerWidth ? 1 : 0,
  };
  document.documentElement.dataset.answer = Object.entries(answer).map(([k, v]) => k + "=" + v).join(";");
});
</script>
JS
timeout --kill-after=5 "$limit_s" chromium --headless --no-sandbox --disable-gpu --disable-dev-shm-usage \
  --user-data-dir="$folder/profile" --dump-dom "file://$folder/looked_at.html" >dom.html 2>browser.txt ||
  fail "the browser ended with status $?: $(tail -n 2 browser.txt)"

answer=$(grep -o 'data-answer="[^"]*"' dom.html) || fail "the page did not load"
expect() {
  [[ $answer == *"$1"* ]] || fail "expected $1 in $answer"
}
# Per study a fit and residuals over velocity, diameter and the table's three other columns; ranking
# and next measurement of the one that is diagnosed; the staircase.
expect "figures=$((2 * 6 + 2 + 1));"
expect "empty=0;"
expect "unlabelled=0;"
expect "twice=0;"
expect "dangling=0;"
expect "requests=0;"
expect "scripts=1;"  # the one above
expect "wide=0"
expect 'title=&lt;script&gt;document.title=1&lt;/script&gt;'

# Values on hover: the first row of the table, and errors of both steps of the staircase.
for text in '1.8 m/s: measured 66.4 ± 3.3 µm; model ' 'finite_stop_pulse: delta BIC ' \
    'with the reduced model' ' predicts '; do
  grep -qF "<title>$text" dom.html || grep -q "<title>[^<]*$text" dom.html || fail "no mark has the title '$text'"
done
# As many SVG files beside the report as figures in it.
files=(report_figures/*.svg)
[[ ${#files[@]} -eq 15 ]] || fail "${#files[@]} SVG files instead of 15"
! grep -lE '(src|href)="(https?:)?//|@import|url\(http' report.html || fail "the page names a file elsewhere"
echo "report in a browser: $answer"
