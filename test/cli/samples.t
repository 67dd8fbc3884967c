Samples, exposure and encoding: settings of a scene and options of the commands.

  $ cat > edge.scene <<EOF
  > imWidth 60 imHeight 40 canvWidth 3 canvHeight 2 depth 2
  > bcolor 0.2 0.3 0.5 samples 8
  > directional 1 white 1 -1 1
  > sphere 0 0 3 1.5 mixed 0.6 diffusive red 0.4 reflective
  > plane 0 -1 0 0 1 0 diffusive white
  > EOF

Bands of it are those of the whole picture, and so is every pixel of a window
that starts coarse: each knows the pixels beside it.

  $ raylab render edge.scene -q -o whole.ppm -j 1
  $ for rows in 0-0 1-16 17-39; do raylab render edge.scene -q --rows $rows -o $rows.ppm; done
  $ raylab join 0-0.ppm 1-16.ppm 17-39.ppm -q -o joined.ppm
  $ cmp whole.ppm joined.ppm

An option goes before the scene, and what it changes is in the label.

  $ raylab render edge.scene -q --samples 1 -o one.ppm
  $ sed 's/samples 8//' edge.scene | raylab render - -q -o none.ppm
  $ cmp one.ppm none.ppm
  $ raylab render edge.scene -q --rows 1-16 --exposure 2 -o brighter.ppm
  $ raylab join 0-0.ppm brighter.ppm -o none.ppm
  raylab: 0-0.ppm and brighter.ppm are not of one picture: the exposures differ, 1 and 2
  [1]
  $ raylab render edge.scene -q --rows 1-16 --srgb -o srgb.ppm
  $ raylab join 0-0.ppm srgb.ppm -o none.ppm
  raylab: 0-0.ppm and srgb.ppm are not of one picture: one is srgb
  [1]
  $ raylab render edge.scene -q --rows 1-16 --samples 4 -o few.ppm
  $ raylab join 0-0.ppm few.ppm -o none.ppm
  raylab: 0-0.ppm and few.ppm are not of one picture: the samples differ, 8 and 4
  [1]
  $ raylab render edge.scene -q -o - --stats 2>&1 >/dev/null | grep -a 'a pixel\|over'
  samples a pixel        2.011
  over-exposed            0.00 %

  $ raylab render edge.scene --samples 0
  raylab: option '--samples': '0' is not a number of samples from 1 to 4096
  Usage: raylab render [OPTION]… SCENE
  Try 'raylab render --help' or 'raylab --help' for more information.
  [124]
  $ raylab render edge.scene --samples 4097
  raylab: option '--samples': '4097' is not a number of samples from 1 to 4096
  Usage: raylab render [OPTION]… SCENE
  Try 'raylab render --help' or 'raylab --help' for more information.
  [124]
  $ raylab render edge.scene --exposure 0
  raylab: option '--exposure': '0' is not an exposure: expected a number
          greater than 0
  Usage: raylab render [OPTION]… SCENE
  Try 'raylab render --help' or 'raylab --help' for more information.
  [124]
  $ raylab slurm edge.scene -o job.png --bands 2 --samples 16 --exposure 0.1 --srgb
  raylab: wrote $TESTCASE_ROOT/job.slurm; to submit it, run $TESTCASE_ROOT/job.slurm/submit
  $ grep '^view' job.slurm/bands.sbatch
  view=('--samples' '16' '--exposure' '0.1' '--srgb')

Why
---

  $ raylab explain edge.scene 17,17
  pixel (17, 17) is rgb 89 59 99: 5 of 8 samples see the dark blue background;
  3 see the mix of 60 % red and 40 % mirror (sphere 1, line 4), lit by light 1,
  whose mirror shows the dark blue background
  
  8 samples, of at most 8, since the centre is rgb 0.2 0.3 0.5
      and that of pixel (18, 16) is rgb 0.631308 0.12 0.2
  
  sample 1, one of 5 that see the dark blue background:
  ray 1: (0, 0, -2) + t (-0.297746, 0.0595491, 0.952786), 4 left in the chain
    hits nothing: the background, rgb 0.2 0.3 0.5
  
  sample 3, one of 3 that see the mix of 60 % red and 40 % mirror (sphere 1,
      line 4), lit by light 1, whose mirror shows the dark blue background:
  ray 1: (0, 0, -2) + t (-0.291821, 0.0546751, 0.954909), 4 left in the chain
    hits sphere 1 (line 4) at t = 4.55942, point (-1.33054, 0.249287, 2.35383),
        normal (-0.887024, 0.166191, -0.430778)
    surface: mixed 0.6 diffusive 1 0 0 0.4 reflective
    that is, emission rgb 0 0 0, albedo rgb 0.6 0 0, mirror 0.4
    light 1 (directional, line 3): lit, cosine 0.856784 * fall-off 1
        * intensity 1 * rgb 1 1 1 = rgb 0.856784 0.856784 0.856784
    all light: rgb 0.856784 0.856784 0.856784
    ray 2, mirrored: (-1.33055, 0.24929, 2.35382)
        + t (-0.546246, 0.102344, 0.831349), 3 left in the chain
      hits nothing: the background, rgb 0.2 0.3 0.5
      emitted  rgb 0 0 0
    + diffused rgb 0.51407 0 0 = albedo * all light
    + mirrored rgb 0.08 0.12 0.2 = 0.4 * colour of ray 2
    = colour of ray 1: rgb 0.59407 0.12 0.2
  
  sum of all 8 samples: rgb 2.7811 1.86 3.1
  divided by their number = colour of the pixel: rgb 0.347637 0.2325 0.3875
  $ raylab explain edge.scene 17,17 --sample 3 | head -6
  pixel (17, 17) is rgb 89 59 99: 5 of 8 samples see the dark blue background;
  3 see the mix of 60 % red and 40 % mirror (sphere 1, line 4), lit by light 1,
  whose mirror shows the dark blue background
  
  sample 3, one of 3 that see the mix of 60 % red and 40 % mirror (sphere 1,
      line 4), lit by light 1, whose mirror shows the dark blue background:
  $ raylab explain edge.scene 17,17 --sample 3 --steps
     1  cast: (0, 0, -2) + t (-0.291821, 0.0546751, 0.954909), 4 left in the chain
     2  nearest hit: object 1, t = 4.55942 at (-1.33054, 0.249287, 2.35383), normal (-0.887024, 0.166191, -0.430778)
     3  shadow ray to light 1: (-1.33055, 0.24929, 2.35382) + t (-0.57735, 0.57735, -0.57735)
     4  light 1: lit, cosine 0.856784, fall-off 1, gives rgb 0.856784 0.856784 0.856784
     5  bounce: (-1.33055, 0.24929, 2.35382) + t (-0.546246, 0.102344, 0.831349), 3 left in the chain
     6  nothing hit: the background, rgb 0.2 0.3 0.5
     7  mix: emitted rgb 0 0 0 + diffused rgb 0.51407 0 0 + mirrored rgb 0.08 0.12 0.2 = rgb 0.59407 0.12 0.2
     8  done: rgb 0.59407 0.12 0.2
  $ raylab explain edge.scene 17,17 --sample 9
  raylab: option --sample: pixel 17,17 has 8 samples, not 9
  [124]
  $ raylab explain edge.scene 30,20 --sample 2
  pixel (30, 20) is rgb 142 59 59: all 4 samples see the mix of 60 % red and 40
  % mirror (sphere 1, line 4), lit by light 1, whose mirror shows the white
  plane (object 2, line 5), lit by light 1
  
  sample 2, one of 4 that see the mix of 60 % red and 40 % mirror (sphere 1,
      line 4), lit by light 1, whose mirror shows the white plane (object 2,
      line 5), lit by light 1:
  ray 1: (0, 0, -2) + t (0.00117935, -0.024248, 0.999705), 4 left in the chain
    hits sphere 1 (line 4) at t = 3.50345,
        point (0.00413178, -0.0849517, 1.50241),
        normal (0.00275452, -0.0566344, -0.998391)
    surface: mixed 0.6 diffusive 1 0 0 0.4 reflective
    that is, emission rgb 0 0 0, albedo rgb 0.6 0 0, mirror 0.4
    light 1 (directional, line 3): lit, cosine 0.542133 * fall-off 1
        * intensity 1 * rgb 1 1 1 = rgb 0.542133 0.542133 0.542133
    all light: rgb 0.542133 0.542133 0.542133
    ray 2, mirrored: (0.00413183, -0.0849528, 1.50239)
        + t (0.00667032, -0.137145, -0.990528), 3 left in the chain
      hits plane 2 (line 5) at t = 6.67209, point (0.0486368, -1, -5.10651),
          normal (0, 1, 0)
      surface: diffusive 1 1 1
      that is, emission rgb 0 0 0, albedo rgb 1 1 1, mirror 0
      light 1 (directional, line 3): lit, cosine 0.57735 * fall-off 1
          * intensity 1 * rgb 1 1 1 = rgb 0.57735 0.57735 0.57735
      all light: rgb 0.57735 0.57735 0.57735
        emitted  rgb 0 0 0
      + diffused rgb 0.57735 0.57735 0.57735 = albedo * all light
      + mirrored rgb 0 0 0
      = colour of ray 2: rgb 0.57735 0.57735 0.57735
      emitted  rgb 0 0 0
    + diffused rgb 0.32528 0 0 = albedo * all light
    + mirrored rgb 0.23094 0.23094 0.23094 = 0.4 * colour of ray 2
    = colour of ray 1: rgb 0.55622 0.23094 0.23094
  $ raylab explain edge.scene 30,20 --sample 0
  raylab: option '--sample': '0' is not the number of a sample; they count from
          1
  Usage: raylab explain [OPTION]… SCENE X,Y…
  Try 'raylab explain --help' or 'raylab --help' for more information.
  [124]
  $ raylab explain edge.scene 30,20 --exposure 3 --srgb | tail -4
  
  sum of all 4 samples: rgb 4 2.77128 2.77128
  divided by their number = colour of the pixel: rgb 1 0.69282 0.69282
  shown by the sRGB curve as rgb 1 0.850408 0.850408

The mean is that of the picture.

  $ raylab explain edge.scene 17,17 --json | grep -A1 '"rgb"'
        "rgb": [ 89, 59, 99 ],
        "summary": "pixel (17, 17) is rgb 89 59 99: 5 of 8 samples see the dark blue background; 3 see the mix of 60 % red and 40 % mirror (sphere 1, line 4), lit by light 1, whose mirror shows the dark blue background",
  $ raylab explain edge.scene 17,17 --svg - | grep -c '<line'
  19
  $ raylab explain edge.scene 17,17 --svg - --sample 1 | grep -c '<line'
  15
