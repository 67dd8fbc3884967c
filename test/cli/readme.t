What README.md says of scenes is true.

The scene in it has no error:

  $ sed -n '/^## A scene/,/^## Using/s/^    //p' ../../README.md > block
  $ sed '/^my.scene/,$d' block > my.scene
  $ raylab check my.scene

The mistake in it is answered as it says:

  $ sed -n '/^my.scene/,$p' block > promised
  $ sed -i 's/mixed .*/difuse red/' my.scene
  $ raylab check my.scene 2> answer
  [1]
  $ diff promised answer
  1,2c1,2
  < my.scene:9:28-33: error: unknown surface 'difuse'
  <     9 |   sphere 0 0 5   1          difuse red
  ---
  > my.scene:8:29-34: error: unknown surface 'difuse'
  >     8 |   sphere 0 0 5   1          difuse red
  [1]
