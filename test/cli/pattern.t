Surfaces and skies that are functions of the point.

  $ cat > header.scene << END
  > imWidth 40 imHeight 30 canvWidth 4 canvHeight 3 depth 4
  > END

A pattern that has no value at a point at which it is tried is an error of the scene.

  $ cat header.scene - > bad.scene << END
  > let ring(p) = (p.x * 10)
  > let paint(p) = diffusive [ring(p), 0.5, 0.5]
  > sphere 0 0 0 1 varying p paint(p)
  > END
  $ raylab check bad.scene
  bad.scene:3:27-33: error: the red of the surface's colour must not be negative, not ring(p), which is -7.40359
      3 | let paint(p) = diffusive [ring(p), 0.5, 0.5]
        |                           ^^^^^^^
  in paint(p: [-0.740359, -0.381845, -0.553229]), called in line 4
  at the point (-0.740359, -0.381845, -0.553229)
  [1]
  $ raylab render bad.scene -o bad.png
  bad.scene:3:27-33: error: the red of the surface's colour must not be negative, not ring(p), which is -7.40359
      3 | let paint(p) = diffusive [ring(p), 0.5, 0.5]
        |                           ^^^^^^^
  in paint(p: [-0.740359, -0.381845, -0.553229]), called in line 4
  at the point (-0.740359, -0.381845, -0.553229)
  [1]
  $ ls *.png
  ls: cannot access '*.png': No such file or directory
  [2]

One that has none only where nobody tried ends the rendering: nothing is written, on
any number of cores, and the same is said by a pixel's explanation.

  $ cat header.scene - > rare.scene << END
  > let at(x) = (if abs(x - 0.35) < 0.000001 then -1 else 0.5)
  > quad -2 -1.5 0 4 0 0 0 3 0 varying p diffusive [at(p.x), 0.5, 0.5]
  > END
  $ raylab check rare.scene
  rare.scene: warning: there is no light: diffusive surfaces are black
  $ for domains in 1 2; do
  >   raylab render rare.scene -o rare.png --domains $domains > log 2>&1
  >   echo $?
  >   sed 's/ point .*/ point .../' log
  > done
  1
  rare.scene: warning: there is no light: diffusive surfaces are black
  raylab: line 3: the red of the surface's colour must not be negative, not at(p.x), which is -1
  raylab: at the point ...
  1
  rare.scene: warning: there is no light: diffusive surfaces are black
  raylab: line 3: the red of the surface's colour must not be negative, not at(p.x), which is -1
  raylab: at the point ...
  $ raylab render rare.scene -o rare.png --rows 3-3 2>&1 | tail -1
  raylab: at the point (0.35, 1.15, 0), in pixel (23, 3)
  $ raylab explain rare.scene 23,3
  rare.scene: warning: there is no light: diffusive surfaces are black
  raylab: line 3: the red of the surface's colour must not be negative, not at(p.x), which is -1
  raylab: at the point (0.35, 1.15, 0), in pixel (23, 3)
  [1]
  $ raylab explain rare.scene 24,3 | head -1
  rare.scene: warning: there is no light: diffusive surfaces are black
  pixel (24, 3) is rgb 0 0 0: a grey quad (object 1, line 3), with no light in
  $ ls *.png
  ls: cannot access '*.png': No such file or directory
  [2]

So does a sky.

  $ cat header.scene - > sky.scene << END
  > END
  $ sed -i 's/depth 4/depth 4 bcolor varying d [if abs(d.x) < 0.000001 then -1 else 0, 0, 1]/; s/imWidth 40/imWidth 41/' sky.scene
  $ raylab render sky.scene -o sky.png > log 2>&1
  [1]
  $ grep -c 'in pixel' log
  1

What is printed can be read, and has the values that are used.

  $ cat header.scene - > values.scene << END
  > let dark = 0.1 0.2 0.3
  > let stripe(x, wide: 2) = (mod(x, wide) < 1)
  > for i = 1 to 2
  >   sphere (i) 0 0 0.4 varying p diffusive [if stripe(9 * p.x) then dark else i * dark]
  > end
  > END
  $ raylab check --expand values.scene 2>/dev/null | tail -n +9 | tee again
  if (true)
  let stripe(x, wide: 2) = (mod(x, wide) < 1)
  let dark = [0.1, 0.2, 0.3]
  let i = 1
  let surface_1 = varying p diffusive [if stripe(9 * p.x) then dark else i * dark]
  sphere 1 0 0 0.4 surface_1  # line 5, i = 1, line 4
  end
  if (true)
  let stripe(x, wide: 2) = (mod(x, wide) < 1)
  let dark = [0.1, 0.2, 0.3]
  let i = 2
  let surface_1 = varying p diffusive [if stripe(9 * p.x) then dark else i * dark]
  sphere 2 0 0 0.4 surface_1  # line 5, i = 2, line 4
  end
  $ raylab check --expand values.scene 2>/dev/null | sed 's/  #.*//' > once.scene
  $ raylab check --expand once.scene 2>/dev/null | sed 's/  #.*//' | cmp - once.scene
