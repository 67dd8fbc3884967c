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
  samples a pixel        2.031
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
  
  sample 2, one of 3 that see the mix of 60 % red and 40 % mirror (sphere 1,
      line 4), lit by light 1, whose mirror shows the dark blue background:
  ray 1: (0, 0, -2) + t (-0.287487, 0.0707045, 0.955171), 4 left in the chain
    hits sphere 1 (line 4) at t = 4.53337, point (-1.30329, 0.32053, 2.33014),
        normal (-0.868857, 0.213686, -0.44657)
    surface: mixed 0.6 diffusive 1 0 0 0.4 reflective
    that is, emission rgb 0 0 0, albedo rgb 0.6 0 0, mirror 0.4
    light 1 (directional, line 3): lit, cosine 0.882834 * fall-off 1
        * intensity 1 * rgb 1 1 1 = rgb 0.882834 0.882834 0.882834
    all light: rgb 0.882834 0.882834 0.882834
    ray 2, mirrored: (-1.3033, 0.320534, 2.33014)
        + t (-0.568401, 0.139792, 0.810789), 3 left in the chain
      hits nothing: the background, rgb 0.2 0.3 0.5
      emitted  rgb 0 0 0
    + diffused rgb 0.529701 0 0 = albedo * all light
    + mirrored rgb 0.08 0.12 0.2 = 0.4 * colour of ray 2
    = colour of ray 1: rgb 0.609701 0.12 0.2
  
  sum of all 8 samples: rgb 2.79621 1.86 3.1
  divided by their number = colour of the pixel: rgb 0.349527 0.2325 0.3875
  $ raylab explain edge.scene 17,17 --sample 4 | head -6
  pixel (17, 17) is rgb 89 59 99: 5 of 8 samples see the dark blue background;
  3 see the mix of 60 % red and 40 % mirror (sphere 1, line 4), lit by light 1,
  whose mirror shows the dark blue background
  
  sample 4, one of 3 that see the mix of 60 % red and 40 % mirror (sphere 1,
      line 4), lit by light 1, whose mirror shows the dark blue background:
  $ raylab explain edge.scene 17,17 --sample 4 --steps
     1  cast: (0, 0, -2) + t (-0.293273, 0.0527619, 0.954572), 4 left in the chain
     2  nearest hit: object 1, t = 4.59914 at (-1.3488, 0.242659, 2.3902), normal (-0.899201, 0.161773, -0.40653)
     3  shadow ray to light 1: (-1.34882, 0.242662, 2.3902) + t (-0.57735, 0.57735, -0.57735)
     4  light 1: lit, cosine 0.847264, fall-off 1, gives rgb 0.847264 0.847264 0.847264
     5  bounce: (-1.34882, 0.242662, 2.3902) + t (-0.501556, 0.0902336, 0.860407), 3 left in the chain
     6  nothing hit: the background, rgb 0.2 0.3 0.5
     7  mix: emitted rgb 0 0 0 + diffused rgb 0.508358 0 0 + mirrored rgb 0.08 0.12 0.2 = rgb 0.588358 0.12 0.2
     8  done: rgb 0.588358 0.12 0.2
  $ raylab explain edge.scene 17,17 --sample 9
  raylab: option --sample: pixel 17,17 has 8 samples, not 9
  [124]
  $ raylab explain edge.scene 30,20 --sample 2
  pixel (30, 20) is rgb 143 59 59: all 4 samples see the mix of 60 % red and 40
  % mirror (sphere 1, line 4), lit by light 1, whose mirror shows the white
  plane (object 2, line 5), lit by light 1
  
  sample 2, one of 4 that see the mix of 60 % red and 40 % mirror (sphere 1,
      line 4), lit by light 1, whose mirror shows the white plane (object 2,
      line 5), lit by light 1:
  ray 1: (0, 0, -2) + t (1.62124e-05, -0.00156002, 0.999999),
      4 left in the chain
    hits sphere 1 (line 4) at t = 3.50001,
        point (5.67438e-05, -0.00546009, 1.50001),
        normal (3.78292e-05, -0.00364006, -0.999993)
    surface: mixed 0.6 diffusive 1 0 0 0.4 reflective
    that is, emission rgb 0 0 0, albedo rgb 0.6 0 0, mirror 0.4
    light 1 (directional, line 3): lit, cosine 0.575223 * fall-off 1
        * intensity 1 * rgb 1 1 1 = rgb 0.575223 0.575223 0.575223
    all light: rgb 0.575223 0.575223 0.575223
    ray 2, mirrored: (5.67445e-05, -0.00546016, 1.49999)
        + t (9.18698e-05, -0.00884004, -0.999961), 3 left in the chain
      hits plane 2 (line 5) at t = 112.504, point (0.0103925, -1, -111),
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
    + diffused rgb 0.345134 0 0 = albedo * all light
    + mirrored rgb 0.23094 0.23094 0.23094 = 0.4 * colour of ray 2
    = colour of ray 1: rgb 0.576074 0.23094 0.23094
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
