# SPDX-License-Identifier: Apache-2.0
# Scenes with several body types for script tests.
contactScene() {  # a block falls on a surface that is held at its rim
  cat <<'SCENE'
spacing = "2 cm"
end = "1 s"
[domain]
min = [-0.5, -0.5, -0.5]
max = [0.5, 0.5, 0.5]
[material.jelly]
density = 200
young = "2 kPa"
[[body]]
name = "block"
box = { size = [0.1, 0.1, 0.1] }
material = "jelly"
place = { move = [0.02, 0, 0.08] }
velocity = [0, 0, -1]
[[oriented]]
name = "net"
patch = { width = 0.5, depth = 0.5 }
density = 5
stiffness = 50
cfl = 0.5
[[oriented.constraint]]
difference = [ { box = { size = [1, 1, 0.1] } }, { box = { size = [0.44, 0.44, 0.2] } } ]
[output]
every = "20 ms"
SCENE
}
clothOver() {  # a cloth that falls on the same surface
  cat <<'SCENE'
[[sheet]]
name = "cloth"
grid = { width = 0.3, depth = 0.3 }
spacing = "2 cm"
mass = 0.4
warp = 20
weft = 20
shear = 4
place = { move = [-0.01, 0.01, 0.018] }
velocity = [0.1, 0, -0.6]
SCENE
}
