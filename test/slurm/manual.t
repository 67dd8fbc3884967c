The commands of the manual, doc/slurm.md, but for parallel's. Here sbatch only
takes what it is given.

  $ cp ../../scenes/first.scene poster.scene
  $ mkdir tools bands
  $ printf '#!/bin/sh\necho 17\n' > tools/sbatch && chmod +x tools/sbatch
  $ PATH=$PWD/tools:$PATH
  $ raylab render poster.scene --rows 0-479 -q -o bands/0.ppm
  $ grep '^    raylab [a-z]' ../../doc/slurm.md > commands
  $ cat commands
      raylab render poster.scene --rows 0-239   -o a.ppm
      raylab render poster.scene --rows 240-479 -o b.ppm
      raylab join a.ppm b.ppm -o poster.png
      raylab slurm poster.scene -o poster.ppm --bands 20 --submit
      raylab join bands -o poster.png
  $ sh -e commands
  raylab: wrote a.ppm
  raylab: wrote b.ppm
  raylab: wrote poster.png
  job 17 renders bands 1-20
  job 17 joins them
  raylab: wrote poster.png
  $ raylab render poster.scene -q -o whole.png
  $ cmp poster.png whole.png

The label that it shows is that of the first band, shortened.

  $ label () { grep -a -m 1 -o 'raylab-band 2.*' $1; }
  $ label a.ppm | sed 's/scene \(.\{6\}\).*\(....\) raylab/scene \1...\2 raylab/' > short
  $ label ../../doc/slurm.md | diff - short

What it says that the folder holds is there.

  $ for name in $(sed -n 's/^| `\([^`]*\)`.*/\1/p' ../../doc/slurm.md); do ls -d poster.slurm/$name; done
  poster.slurm/picture.scene
  poster.slurm/bands.sbatch
  poster.slurm/join.sbatch
  poster.slurm/submit
  poster.slurm/bands/
