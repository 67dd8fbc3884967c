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
