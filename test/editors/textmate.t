What an editor colours, by the grammar that many read.

  $ cat > a.scene <<EOF
  > include "a.scene"   # let sphere
  > imWidth 640   DEPTH 4.5e1
  > let ring(n, red: 2) = group sphere (sin(pi * n) + 2.5) -1 .5 1
  >   mixed 0.5 diffusive red 0.5 reflective end scaled 2
  > for i = 1 to 9 if (i > 3 and not true) ring2 spheres 0 [1, nth([sphere], 2)]
  > EOF
  $ node colour.js ../../doc/editors/raylab.tmLanguage.json a.scene | sed 's/\.raylab / /'
  keyword.control include
  string.quoted.double "a.scene"
  comment.line.number-sign # let sphere
  support.type.property-name imWidth
  constant.numeric 640
  support.type.property-name DEPTH
  constant.numeric 4.5e1
  keyword.control let
  entity.name.function ring
  constant.numeric 2
  support.class.shape group
  support.class.shape sphere
  support.function sin
  constant.language pi
  keyword.operator *
  keyword.operator +
  constant.numeric 2.5
  constant.numeric -1
  constant.numeric .5
  constant.numeric 1
  support.type.surface mixed
  constant.numeric 0.5
  support.type.surface diffusive
  constant.language.colour red
  constant.numeric 0.5
  support.type.surface reflective
  keyword.control end
  keyword.other.modifier scaled
  constant.numeric 2
  keyword.control for
  constant.numeric 1
  keyword.control to
  constant.numeric 9
  keyword.control if
  keyword.operator >
  constant.numeric 3
  keyword.operator.word and
  keyword.operator.word not
  keyword.operator.word true
  constant.numeric 0
  constant.numeric 1
  support.function nth
  constant.numeric 2
