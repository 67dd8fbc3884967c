What is allowed but hardly meant is told once by whatever reads a scene, on
standard error, and what is asked for is done all the same.

  $ cat > dark.scene <<EOF
  > imWidth 8   imHeight 6   canvWidth 4   canvHeight 3   depth 4
  > let red = 0.9 0.1 0.1
  > sphere 0 0 3 1  diffusive red
  > sphere 0 0 3 1  diffusive blue
  > EOF
  $ raylab check dark.scene
  dark.scene: warning: 'red' is a name from here to the end of its block, and no longer the word of the language (line 2)
  dark.scene: warning: there is no light: diffusive surfaces are black
  dark.scene: warning: sphere 2 is where sphere 1 is: they hide each other (lines 3 and 4)
  $ raylab render dark.scene -o dark.ppm
  dark.scene: warning: 'red' is a name from here to the end of its block, and no longer the word of the language (line 2)
  dark.scene: warning: there is no light: diffusive surfaces are black
  dark.scene: warning: sphere 2 is where sphere 1 is: they hide each other (lines 3 and 4)
  raylab: wrote dark.ppm
  $ raylab explain dark.scene 4,3 > said
  dark.scene: warning: 'red' is a name from here to the end of its block, and no longer the word of the language (line 2)
  dark.scene: warning: there is no light: diffusive surfaces are black
  dark.scene: warning: sphere 2 is where sphere 1 is: they hide each other (lines 3 and 4)
  $ raylab explain dark.scene 4,3 --json > said
  dark.scene: warning: 'red' is a name from here to the end of its block, and no longer the word of the language (line 2)
  dark.scene: warning: there is no light: diffusive surfaces are black
  dark.scene: warning: sphere 2 is where sphere 1 is: they hide each other (lines 3 and 4)
  $ raylab slurm dark.scene -o job.ppm --bands 2
  dark.scene: warning: 'red' is a name from here to the end of its block, and no longer the word of the language (line 2)
  dark.scene: warning: there is no light: diffusive surfaces are black
  dark.scene: warning: sphere 2 is where sphere 1 is: they hide each other (lines 3 and 4)
  raylab: wrote $TESTCASE_ROOT/job.slurm; to submit it, run $TESTCASE_ROOT/job.slurm/submit
  $ DISPLAY= raylab dark.scene
  dark.scene: warning: 'red' is a name from here to the end of its block, and no longer the word of the language (line 2)
  dark.scene: warning: there is no light: diffusive surfaces are black
  dark.scene: warning: sphere 2 is where sphere 1 is: they hide each other (lines 3 and 4)
  raylab: wrote dark.bmp
  raylab: no display was found: DISPLAY is not set. The picture is not shown
  $ DISPLAY= raylab view dark.scene
  dark.scene: warning: 'red' is a name from here to the end of its block, and no longer the word of the language (line 2)
  dark.scene: warning: there is no light: diffusive surfaces are black
  dark.scene: warning: sphere 2 is where sphere 1 is: they hide each other (lines 3 and 4)
  raylab: no display was found: DISPLAY is not set
  [2]
  $ DISPLAY= raylab view dark.scene --watch
  dark.scene: warning: 'red' is a name from here to the end of its block, and no longer the word of the language (line 2)
  dark.scene: warning: there is no light: diffusive surfaces are black
  dark.scene: warning: sphere 2 is where sphere 1 is: they hide each other (lines 3 and 4)
  raylab: no display was found: DISPLAY is not set
  [2]
  $ raylab render - -o - < dark.scene > out.bmp
  -: warning: 'red' is a name from here to the end of its block, and no longer the word of the language (line 2)
  -: warning: there is no light: diffusive surfaces are black
  -: warning: sphere 2 is where sphere 1 is: they hide each other (lines 3 and 4)
  $ cmp out.bmp dark.bmp

Not if nothing is to be told, and not by the tasks of a job.

  $ raylab render -q dark.scene -o dark.ppm
  $ (cd job.slurm && SLURM_ARRAY_TASK_ID=1 bash bands.sbatch)

What is told is true of the picture as options make it.

  $ cat > soft.scene <<EOF
  > imWidth 8   imHeight 8   canvWidth 4   canvHeight 3   depth 4   aperture 0.1
  > sphere 0 0 3 1  luminous 200 180 140
  > EOF
  $ raylab check soft.scene
  soft.scene: warning: samples is 1: whatever the aperture, everything is sharp; say samples 64 or so
  soft.scene: warning: canvas and picture differ in proportions: the picture looks 1.33 times as high as it should
  soft.scene: warning: sphere 1 has the colour 200 180 140, which looks like 0 to 255; from 0 to 1 it is 0.784 0.706 0.549 (line 2)
  $ raylab render soft.scene -o soft.ppm
  soft.scene: warning: samples is 1: whatever the aperture, everything is sharp; say samples 64 or so
  soft.scene: warning: canvas and picture differ in proportions: the picture looks 1.33 times as high as it should
  soft.scene: warning: sphere 1 has the colour 200 180 140, which looks like 0 to 255; from 0 to 1 it is 0.784 0.706 0.549 (line 2)
  raylab: wrote soft.ppm
  $ raylab render soft.scene -o soft.ppm --samples 4
  soft.scene: warning: canvas and picture differ in proportions: the picture looks 1.33 times as high as it should
  soft.scene: warning: sphere 1 has the colour 200 180 140, which looks like 0 to 255; from 0 to 1 it is 0.784 0.706 0.549 (line 2)
  raylab: wrote soft.ppm
  $ raylab render soft.scene -o soft.ppm --size 8x6 --grey
  soft.scene: warning: samples is 1: whatever the aperture, everything is sharp; say samples 64 or so
  soft.scene: warning: sphere 1 has the colour 200 180 140, which looks like 0 to 255; from 0 to 1 it is 0.784 0.706 0.549 (line 2)
  raylab: wrote soft.ppm
  $ raylab render soft.scene -o soft.ppm --size 16x16
  soft.scene: warning: samples is 1: whatever the aperture, everything is sharp; say samples 64 or so
  soft.scene: warning: canvas and picture differ in proportions: the picture looks 1.33 times as high as it should
  soft.scene: warning: sphere 1 has the colour 200 180 140, which looks like 0 to 255; from 0 to 1 it is 0.784 0.706 0.549 (line 2)
  raylab: wrote soft.ppm
  $ raylab render soft.scene -o soft.ppm --size 4x8
  soft.scene: warning: samples is 1: whatever the aperture, everything is sharp; say samples 64 or so
  soft.scene: warning: sphere 1 has the colour 200 180 140, which looks like 0 to 255; from 0 to 1 it is 0.784 0.706 0.549 (line 2)
  raylab: warning: --size 4x8 distorts the picture, which looks 2.67 times as high as it should; 4x3 would not
  raylab: wrote soft.ppm

An error is told alone: nothing is done.

  $ echo 'sphere 0 0 3' >> dark.scene
  $ raylab render dark.scene -o dark.ppm
  dark.scene:6:1: error: the file ends where a number should follow
      6 | 
        | ^
  expected the radius of the sphere after its centre.
  [1]
