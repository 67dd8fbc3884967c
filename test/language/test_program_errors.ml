(* Faulty programs. What is said of each was written before it was said. *)

let check name block =
  Alcotest.test_case name `Quick (fun () ->
      Read.check_errors name
        ("\nimWidth 4 imHeight 3 canvWidth 8 canvHeight 6 depth 5\n" ^ block))

let names =
  [
    check "unknown in brackets"
      {|sphere 0 0 (far) 1 reflective
            ^^^ unknown name 'far'|};
    check "unknown outside"
      {|sphere 0 0 far 1 reflective
           ^^^ 'far' is not a number|};
    check "told once"
      {|sphere 0 0 (far) 1 reflective
            ^^^ unknown name 'far'
sphere 0 1 (far) 1 reflective|};
    check "nothing follows from a broken definition"
      {|let r = (1 / 0)
         ^^^^^ 1 / 0 is not a finite number: it is 1 / 0
sphere 0 0 6 (r) reflective sphere 0 0 6 (2 * r) reflective|};
    check "nothing follows from a broken part of a solid"
      {|difference sphere 0 0 (1 / 0) 1 reflective end
                       ^^^^^ 1 / 0 is not a finite number: it is 1 / 0
intersection for i = 1 to 1 sphere 0 0 (far) 1 reflective end end
                                        ^^^ unknown name 'far'|};
    check "own definition"
      {|let red = diffusive red
                    ^^^ 'red' stands in its own definition|};
    check "twice" {|let a = 1
let A = 2
    ^ A is defined a second time|};
    check "after its block"
      {|for i = 0 to 1 sphere 0 0 (i + 6) 1 reflective end
sphere 0 0 (i) 1 reflective
            ^ unknown name 'i'|};
    check "reserved"
      {|let end = 1
    ^^^ a name should stand here, not 'end'|};
    check "no name" {|let my-ball = 1
    ^^^^^^^ 'my-ball' is not a name|};
    check "unknown function"
      {|sphere 0 0 (sine(3)) 1 reflective
            ^^^^ unknown function 'sine'|};
  ]

let kinds =
  [
    check "a vector for a number"
      {|let p = 0 0 6
sphere [p] p reflective
           ^ a number should stand here, and p is a vector, [0, 0, 6]|};
    check "a number for a vector"
      {|sphere [6] 1 reflective
        ^ a vector should stand here, and 6 is a number, 6|};
    check "a surface for an object"
      {|let matt = diffusive white
matt
^^^^ an object or a light should stand here, and matt is a surface|};
    check "a number for a surface"
      {|let k = 1
sphere 0 0 6 1 k
               ^ a surface should stand here, and k is a number, 1|};
    check "a number for a condition"
      {|if (1) sphere 0 0 6 1 reflective end
    ^ a condition (true or false) should stand here, and 1 is a number, 1|};
    check "a sum of text"
      {|let a = (1 + "b")
         ^^^^^^^ 1 + "b" has no value: a number + a text|};
    check "comparing kinds"
      {|let a = (1 = true)
         ^^^^^^^^ 1 = true has no value: a number = a truth value|};
    check "calling a number"
      {|let a = 1
let b = (a(2))
         ^^^^ a is a number, not a function|};
    check "a list of no list"
      {|for i in [5] sphere 0 0 (i) 1 reflective end
let five = 5
for i in five sphere 0 0 6 1 reflective end
         ^^^^ a list should stand here, and five is a number, 5|};
  ]

let calls =
  [
    check "too few"
      {|let ball(r, z) = sphere 0 0 z r reflective
ball(1)
^^^^^^^ ball lacks z|};
    check "too many"
      {|let ball(r) = sphere 0 0 6 r reflective
ball(1, 2)
        ^ ball takes 1 argument, not 2|};
    check "a label that is none"
      {|let ball(r) = sphere 0 0 6 r reflective
ball(s: 1)
     ^ ball has no parameter s|};
    check "twice"
      {|let ball(r) = sphere 0 0 6 r reflective
ball(1, r: 2)
        ^ ball gets r twice|};
    check "too many for sin"
      {|let a = (sin(1, 2))
                ^ sin takes 1 argument, not 2|};
    check "of the wrong kind"
      {|let a = (sin([1, 2, 3]))
         ^^^^^^^^^^^^^^ sin([1, 2, 3]) has no value|};
    check "an element too far"
      {|let a = (nth([1, 2], 2))
         ^^^^^^^^^^^^^^ nth([1, 2], 2) has no value: the list has 2 elements|};
    check "a root of a negative number"
      {|let a = (sqrt(-1))
         ^^^^^^^^ sqrt(-1) is not a finite number|};
    check "without end"
      {|let f(n) = (f(n + 1))
            ^^^^^^^^ more than 1,000 calls are nested
let a = f(0)|};
  ]

let rules =
  [
    check "a negative radius"
      {|for i = 0 to 2 sphere 0 0 6 (i - 1) reflective end
                             ^^^^^ the radius must be greater than 0, not i - 1, which is -1|};
    check "a step of 0"
      {|for i = 0 to 2 by 0 sphere 0 0 6 1 reflective end
                  ^ the step of a loop must not be 0|};
    check "a loop without end"
      {|for i = 0 to 1e99 end
    ^ the evaluation takes more than 100,000,000 steps|};
    check "stretched by nothing"
      {|sphere 0 0 6 1 reflective stretched 1 0 1
                          ^^^^^^^^^ a factor of stretched must not be 0|};
    check "stretched out of the range of numbers"
      {|sphere 0 0 6 1 reflective stretched 1e300 1 1 translated 1 0 0 stretched 1e300 1 1
^^^^^^^^^^^^^^ its modifiers leave the range of numbers|};
    check "empty groups in empty groups"
      {|let twice(n) = group if (n > 0) let x = twice(n - 1) x x end end
twice(100)
^^^^^^^^^^ the evaluation takes more than 100,000,000 steps|};
    check "scaled by nothing"
      {|sphere 0 0 6 1 reflective scaled 0
                                 ^ the factor must be greater than 0, not 0|};
    check "rotated around nothing"
      {|sphere 0 0 6 1 reflective rotated 0 0 0 90
                                  ^^^^^ the axis must not be the zero vector|};
    check "several"
      {|sphere 0 0 6 (1 - 2) diffusive [1, 0 - 1, 0]
              ^^^^^ the radius must be greater than 0, not 1 - 2, which is -1
                                   ^^^^^ the green of the surface's colour must not be negative, not 0 - 1, which is -1|};
  ]

let solids =
  [
    check "a flat shape"
      {|difference sphere 0 0 6 1 reflective disc 0 0 5 0 0 1 1 reflective end
                                     ^^^^ a disc cannot be part of a difference: it has no inside|};
    check "a light"
      {|union sphere 0 0 6 1 reflective directional 1 1 1 1 0 -1 0 end
                                ^^^^^^^^^^^ a light cannot be part of a union: it has no inside|};
    check "a flat shape in a group"
      {|let both = group sphere 0 0 6 1 reflective quad 0 0 6 1 0 0 0 1 0 reflective end
intersection both sphere 0 0 6 2 reflective end
             ^^^^ a quad cannot be part of an intersection: it has no inside|};
    check "nothing"
      {|intersection end
^^^^^^^^^^^^^^^^ an intersection of nothing|};
    check "a part without a shadow"
      {|union sphere 0 0 6 1 reflective shadowless sphere 0 0 7 1 reflective end
      ^^^^^^^^^^^^^^ what is shadowless cannot be part of a union: it would leave a hole in the shadow of the whole|};
    check "a light without a shadow"
      {|directional 1 1 1 1 0 -1 0 shadowless
                           ^^^^^^^^^^ a light has no shadow|};
    check "an object that should not fade"
      {|sphere 0 0 6 1 reflective unfading
                          ^^^^^^^^ there is no light that could be unfading|};
    check "a group without a light"
      {|let balls = group sphere 0 0 6 1 reflective end
balls unfading
      ^^^^^^^^ there is no light that could be unfading|};
  ]

let lamps =
  [
    check "the angles of a spot, the other way round"
      {|spot 1 white 0 3 0 0 0 0 20 10
^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ the inner angle, 20 degrees, is greater than the outer one, 10|};
    check "more than all around"
      {|spot 1 white 0 3 0 0 0 0 20 (2 * 90)
^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ the outer angle must be less than 180 degrees, not 180|};
    check "a negative angle"
      {|spot 1 white 0 3 0 0 0 0 -1 10
                         ^^ the inner angle must not be negative, not -1|};
    check "a spot that shines at itself"
      {|spot 1 white 0 3 0 0 3 0 10 20
^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ the light and its target are one point, or too far apart|};
    check "half a point"
      {|area 1 white 0 3 0 1 0 0 0 0 1 2.5
                               ^^^ the number of points along an edge must be a whole number from 1 to 64, not 2.5|};
    check "too many points"
      {|area 1 white 0 3 0 1 0 0 0 0 1 65
                               ^^ the number of points along an edge must be a whole number from 1 to 64, not 65|};
    check "too far away"
      {|area 1 white 1e308 3 0 1e308 0 0 0 0 1 2
^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ the corners of the area light are too far away|};
    check "put on its target"
      {|spot 1 white 1e16 3 0 1e16 3 1e-9 10 20 translated 0 0 1e9
^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^^ its modifiers leave the range of numbers|};
  ]

let syntax =
  [
    check "an equals sign of C"
      {|let a = (1 == 1)
           ^^ '==' is no operator|};
    check "an open bracket"
      {|let a = (1 + 2
              ^ the file ends where an operator should follow|};
    check "an open group"
      {|group sphere 0 0 6 1 reflective
                               ^ the file ends where an item should follow|};
    check "a loop without a range"
      {|for i sphere 0 0 6 1 reflective end
      ^^^^^^ '=' or 'in' should stand here, not 'sphere'|};
    check "if without brackets"
      {|if true end
   ^^^^ 'true' is not a condition|};
    check "end without a beginning"
      {|sphere 0 0 6 1 reflective end
                          ^^^ a shape should stand here, not 'end'|};
    check "an operand that lacks"
      {|let a = (1 + )
             ^ a value should stand here, not ')'|};
    check "include in a value"
      {|let a = include "a.scene"
        ^^^^^^^ a value should stand here, not 'include'|};
    check "include without a file"
      {|include 3
        ^ a file name should stand here, not '3'|};
    check "include without quotes"
      {|include a.scene
        ^^^^^^^ unknown file name 'a.scene'|};
    check "include where nothing can be read"
      {|include "a.scene"
        ^^^^^^^^^ 'a.scene' cannot be included: no other file can be read here|};
    check "a part that is none"
      {|let p = 1 2 3
let a = (p.w)
          ^^ '.w' is no operator|};
  ]

let suite =
  ( "Faulty programs",
    List.concat [ names; kinds; calls; rules; solids; lamps; syntax ] )
