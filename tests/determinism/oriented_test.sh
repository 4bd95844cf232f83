#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# Oriented bodies (scenes/oriented): the same bits on 1, 2, 3, 4 and 7 ranks and over a restart on another
# number of ranks. Covers births, deaths, cuts, welds, constraints, and contact with a continuum body and a
# cloth.
# SCENES selects scenes.
. "$(dirname "$0")/../support/run.sh"
scenes=$source_dir/scenes/oriented
same() { sameRuns "$1" "$2" "$3" "frames/${scene}_oriented.hdf.series"; }  # same A B WHAT
try() {  # try NAME FILE STEPS SETTINGS
  scene=$(basename "$2" .toml)
  sameOnAllRanks "$1" "$3" - "$2" "${@:4}"
  echo "$1: $(value "$work/$1.1/summary.json" oriented) particles, \
$(value "$work/$1.1/summary.json" oriented_births) births, \
$(value "$work/$1.1/summary.json" oriented_deaths) deaths"
  rm -rf "${work:?}/$1".*
}
. "$(dirname "$0")/../support/contact_scene.sh"
# A block falls on a surface that is held at its rim. Then a cloth lies on the surface and the block on the
# cloth, while a patch flies out of the domain.
contactScene >"$work/contact.toml"
{ contactScene; clothOver; cat <<'EOF'
[[oriented]]
name = "patch"
patch = { width = 0.3, depth = 0.3 }
place = { move = [0, 0, -0.05] }
growth = "gaps"
[[oriented]]
name = "leaver"
patch = { width = 0.1, depth = 0.1 }
place = { move = [0.4, 0, 0.3] }
velocity = [4, 0, 0]
EOF
} >"$work/sheet_contact.toml"
# each copy goes with its runs
for copy in blow interpenetration tumbling; do cp "$work/contact.toml" "$work/$copy.toml"; done
known="contact blow interpenetration tumbling sheet_contact control relax_plane relax_sphere open_cap weld cut
crease"
known+=" interpolate curve2d rk4 implicit retry"
for which in ${SCENES:-$known}; do
  case $which in
    # a step that is too long: rollback with the same bits on all ranks, stopped between rollback and failure
    retry)
      scene=relax_plane
      options=(--set numerics.fixed_step=2.5e-3 --set numerics.retry_every=10 --set end=0.2
        --set output.every=0.02)
      for ranks in 1 3 7; do
        launch $ranks run "$scenes/relax_plane.toml" "${options[@]}" --out "$work/retry.$ranks" \
          >"$work/log" 2>&1
        expectExit 0 "relax_plane with long steps on $ranks ranks"
        expectMessage "^warning: failed at step .*; back to step" \
          "relax_plane with long steps on $ranks ranks"
        [ "$ranks" = 1 ] ||
          same "$work/retry.1" "$work/retry.$ranks" "relax_plane with long steps on 1 and $ranks ranks"
      done
      launch 3 run "$scenes/relax_plane.toml" "${options[@]}" --steps 3 --out "$work/retry.parts" \
        >"$work/log" 2>&1
      expectExit 0 "relax_plane with long steps, first part"
      launch 2 run "$scenes/relax_plane.toml" "${options[@]}" --restart --out "$work/retry.parts" \
        >"$work/log" 2>&1
      expectExit 0 "relax_plane with long steps, last part"
      same "$work/retry.1" "$work/retry.parts" "relax_plane with long steps, stopped before it fails"
      echo "retry: $(value "$work/retry.1/summary.json" retries) retries, \
$(value "$work/retry.1/summary.json" step) steps"
      ;;
    contact) try contact "$work/contact.toml" 150 ;;
    blow)  # a stiff, heavy and fast block on a light surface: the contact barrier and its step limit
      try blow "$work/blow.toml" 150 --set material.jelly.density=1000 --set material.jelly.young=1e5 \
        --set oriented.net.density=1 --set oriented.net.stiffness=10 --set body.block.velocity=[0.2,0,-2] \
        --set body.block.place.move=[0.02,0,0.075]
      ;;
    interpenetration)  # a block that begins inside the surface: one warning, with the same text on all ranks
      scene=interpenetration
      for ranks in 1 3 7; do
        launch $ranks run "$work/interpenetration.toml" --set 'numerics.overlap="keep"' \
          --set body.block.velocity=[0,0,0] --set body.block.place.move=[0.02,0,0.01] \
          --set numerics.retry_every=5 --steps 20 --out "$work/interpenetration.$ranks" >"$work/log" 2>&1
        expectExit 0 "a block in a surface on $ranks ranks"
        grep '^warning: .*are inside body' "$work/log" | sort -u >"$work/interpenetration.$ranks.warnings"
        [ "$(wc -l <"$work/interpenetration.$ranks.warnings")" = 1 ] ||
          fail "a block in a surface on $ranks ranks: not one warning"
        cmp "$work/interpenetration.1.warnings" "$work/interpenetration.$ranks.warnings" ||
          fail "a block in a surface: the warnings on 1 and $ranks ranks differ"
      done
      cat "$work/interpenetration.1.warnings" ;;
    # the block rotates in contact, so its rows change order in steps whose contacts read data of the last
    # step
    tumbling)
      try tumbling "$work/tumbling.toml" 150 --set body.block.velocity=[0.6,0.3,-1] \
        --set body.block.spin=[9,12,6] --set body.block.box.size=[0.16,0.16,0.16] \
        --set body.block.place.move=[0.02,0,0.11]
      ;;
    sheet_contact) try sheet_contact "$work/sheet_contact.toml" 150 ;;
    rk4) settings cut; try rk4 "$scenes/cut.toml" 40 "${set[@]}" --set 'oriented.cloth.integrator="rk4"' ;;
    implicit)
      settings weld
      try implicit "$scenes/weld.toml" 30 "${set[@]}" --set 'oriented.left.integrator="semi-implicit"'
      ;;
    relax_*) settings "$which"; try "$which" "$scenes/$which.toml" 60 "${set[@]}" ;;  # relaxation only
    *) settings "$which"; try "$which" "$scenes/$which.toml" 150 "${set[@]}" ;;
  esac
done
finish
