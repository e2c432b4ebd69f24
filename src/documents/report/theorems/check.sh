#!/usr/bin/env bash
# Compiles the theorems of this folder and says of each file whether Coq accepts it; holds each theorem against
# statements.v, prints the axioms that they rest on and holds them against a list.
#
#     bash check [NAME…]      # the files of these claims, and what they cite; all if none is given
#
# LIMIT: the most seconds for each file (default 120). JOBS: how many at a time (default 2). KEEP: a folder that takes the
# compiled files. EACH=yes: the axioms of each theorem by itself, which takes half a second for each. ALONE=yes: a process
# for each file, which takes a second more for each; else that is done only where a file is not accepted.
# Exit code 0: all as it should be, 1: not, 2: Coq is missing or a NAME is unknown.
set -uo pipefail
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
limit=${LIMIT:-120} jobs=${JOBS:-2}
# Coq collects garbage more seldom: a seventh less time.
export OCAMLRUNPARAM=${OCAMLRUNPARAM:-s=16M}

# The axioms of Coq's real numbers and of classical logic; nothing else.
allowed="ClassicalDedekindReals.sig_forall_dec
ClassicalDedekindReals.sig_not_dec
FunctionalExtensionality.functional_extensionality_dep
Classical_Prop.classic"

if ! command -v coqc > /dev/null || ! [ -d "$(coqc -where)/user-contrib/Coquelicot" ]; then
  echo "error: Coq with Coquelicot is needed: apt-get install coq libcoq-coquelicot, or opam install coq coq-coquelicot" >&2
  exit 2
fi

# What is asked for, and what that needs.
declare -A needs wanted
files=()
while read -r name rest; do needs[$name]=$rest files+=("$name"); done < "$here/order.txt"
want() {
  local name=${1%.v}
  if [ -z "${needs[$name]+known}" ]; then echo "error: order.txt has no file $name" >&2; exit 2; fi
  [ -z "${wanted[$name]+seen}" ] || return 0
  wanted[$name]=yes
  local need
  for need in ${needs[$name]}; do want "$need"; done
}
for name in "${@:-${files[@]}}"; do want "$name"; done

# A clean folder: a stale compiled file could hold anything.
clean=$(mktemp -d)
trap 'kill $(jobs -p) 2> /dev/null; rm -rf "$clean"' EXIT
cp "$here"/*.v "$clean"
cd "$clean" || exit 1
coq() { timeout "$limit" coqc -w none -Q . Carom "$@"; }
compile() {
  local name=$1 begun=$EPOCHREALTIME code=0 need said
  for need in ${needs[$name]:-}; do
    if [ "$(cat "$need.done")" != 0 ]; then
      echo "not tried  $name: it needs $need"
      echo skipped > "$name.done"
      return
    fi
  done
  coq "$name.v" > "$name.log" 2>&1 || code=$?
  case $code in
    0) said="accepted   $name" ;;
    124 | 137) said="timed out  $name after $limit s" ;;
    *) said="failed     $name: $(tr -s ' \n' ' ' < "$name.log" | cut -c 1-300)" ;;
  esac
  echo "$said ($(awk "BEGIN { printf \"%.1f\", $EPOCHREALTIME - $begun }") s)"
  echo "$code" > "$name.done"
}

while read -r name; do
  coqc -w none -Q . Carom "$name.v" || { echo "error: $name.v, which all rests on, does not compile" >&2; exit 1; }
done < "$here/library.txt"

# Most of the time of a small file goes into loading Coq's library. So the files are put together, each as a module of its
# name, into as many as are compiled at a time; what a file needs stands before it in the same one.
declare -A placed holder
size=()
place() {
  local batch=$1 name=$2 need
  [ -z "${placed[$batch $name]+yes}" ] || return 0
  placed[$batch $name]=yes
  for need in ${needs[$name]}; do place "$batch" "$need"; done
  holder[$name]=together_$batch
  { echo "Module $name."; grep -v '^From Carom Require ' "$name.v"; echo "End $name."; } >> "together_$batch.v"
  size[batch]=$((size[batch] + $(wc -c < "$name.v")))
}
compile_together() {
  local name batch least done=()
  [ -z "${KEEP:-}${ALONE:-}" ] && [ "${#wanted[@]}" -gt 3 ] || return 1
  for ((batch = 0; batch < jobs; batch++)); do
    size[batch]=0
    for name in "${!wanted[@]}"; do grep -h '^From Carom Require Import ' "$name.v"; done | sort -u > "together_$batch.v"
  done
  for name in "${files[@]}"; do
    [ -n "${wanted[$name]+yes}" ] || continue
    least=0
    for ((batch = 1; batch < jobs; batch++)); do [ "${size[batch]}" -ge "${size[least]}" ] || least=$batch; done
    place "$least" "$name"
  done
  for ((batch = 0; batch < jobs; batch++)); do
    timeout $((limit * ${#wanted[@]})) coqc -w none -Q . Carom "together_$batch.v" > /dev/null 2>&1 &
    done+=($!)
  done
  for batch in "${!done[@]}"; do wait "${done[batch]}" || { kill "${done[@]}" 2> /dev/null; wait; return 1; }; done
  for name in "${files[@]}"; do
    [ -n "${wanted[$name]+yes}" ] || continue
    echo "accepted   $name"
    echo 0 > "$name.done"
  done
}

compile_alone() {
  local running=0
  for name in "${files[@]}"; do
    [ -n "${wanted[$name]+yes}" ] || continue
    for need in ${needs[$name]}; do
      while ! [ -e "$need.done" ]; do wait -n; running=$((running - 1)); done
    done
    while [ "$running" -ge "$jobs" ]; do wait -n; running=$((running - 1)); done
    compile "$name" &
    running=$((running + 1))
  done
  wait
}
compile_together || { holder=(); compile_alone; }

[ -z "${KEEP:-}" ] || cp ./*.vo "$KEEP"

# What the theorems say, and what they rest on.
accepted=0 failed=() late=() skipped=()
for name in "${files[@]}"; do
  [ -n "${wanted[$name]+yes}" ] || continue
  case $(cat "$name.done" 2> /dev/null) in
    0) accepted=$((accepted + 1)) ;;
    124 | 137) late+=("$name") ;;
    skipped) skipped+=("$name") ;;
    *) failed+=("$name") ;;
  esac
done
wrong=0 theorems=()
# What is typed says that each theorem is what statements.v says; one question for all of them walks through the library once.
{
  echo "From Carom Require statements."
  while read -r name theorem says; do
    [ "$(cat "$name.done" 2> /dev/null)" = 0 ] || continue
    theorems+=("$theorem")
    # Nothing is imported: no file has a say in what statements.v means.
    echo "From Carom Require ${holder[$name]:-$name}."
    echo "Definition the_theorem_$theorem : $says := ${holder[$name]:+${holder[$name]}.}$name.$theorem."
  done < "$here/theorems.txt"
  echo "Definition all_theorems := ("
  for theorem in ${theorems[@]+"${theorems[@]}"}; do echo "the_theorem_$theorem,"; done
  echo "I)."
} > stated.v
if ! coqc -w none -Q . Carom stated.v > stated.log 2>&1; then
  cat stated.log >&2
  echo "error: a theorem does not say what statements.v says: $(grep -oE 'the_theorem_[A-Za-z0-9_'"'"']+' stated.log | head -n 1)" >&2
  wrong=1 theorems=()
fi
# The axioms that a term of stated.v rests on.
axioms() {
  printf 'From Carom Require stated.\nPrint Assumptions stated.%s.\n' "$1" > assumptions.v
  coqc -w none -Q . Carom assumptions.v > axioms.log 2>&1 && grep -qE '^(Axioms|Closed)' axioms.log || return 1
  sed -nE 's/^([A-Za-z_][A-Za-z0-9_.'"'"']*)( :.*)?$/\1/p' axioms.log | grep -vE '^(Axioms|Closed)' | sort -u || true
}
foreign() { grep -vxF "$allowed" <<< "$1" | grep . || true; }
if [ "${#theorems[@]}" -gt 0 ]; then
  all=$(axioms all_theorems) || { echo "error: nothing is known of what the theorems rest on" >&2; wrong=1 theorems=(); }
  if [ "$wrong" = 0 ] && { [ -n "$(foreign "$all")" ] || [ -n "${EACH:-}" ]; }; then
    for theorem in "${theorems[@]}"; do
      own=$(axioms "the_theorem_$theorem") || wrong=1
      echo "axioms of $theorem: $(tr '\n' ' ' <<< "${own:-none}")"
      bad=$(foreign "$own")
      [ -z "$bad" ] || echo "error: $theorem rests on what is not allowed: $bad" >&2
    done
    [ -z "$(foreign "$all")" ] || wrong=1
  fi
  if [ "$wrong" = 0 ]; then
    for theorem in ${theorems[@]+"${theorems[@]}"}; do echo "theorem    $theorem"; done
    echo "axioms of these theorems: $(tr '\n' ' ' <<< "${all:-none}")"
  fi
fi
count=${#theorems[@]}
list() { local what=$1; shift; [ $# = 0 ] || echo "$what: $*"; }
list failed ${failed[@]+"${failed[@]}"}
list "timed out" ${late[@]+"${late[@]}"}
list "not tried" ${skipped[@]+"${skipped[@]}"}
echo "files accepted $accepted, failed ${#failed[@]}, timed out ${#late[@]}, not tried ${#skipped[@]}; theorems accepted $count"
[ "$wrong" = 0 ] && [ $((${#failed[@]} + ${#late[@]} + ${#skipped[@]})) = 0 ]
