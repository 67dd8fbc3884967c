open Raylab_geometry

type body =
  | Number of (float -> float)
  | Number_2 of (float -> float -> float)
  | Number_3 of (float -> float -> float -> float)
  | Of_vector of (Vec3.t -> float)
  | Of_vectors of (Vec3.t -> Vec3.t -> float)
  | Vector of (Vec3.t -> Vec3.t)
  | Vectors of (Vec3.t -> Vec3.t -> Vec3.t)
  | To_vector of (float -> float -> float -> Vec3.t)
  | Vector_number of (Vec3.t -> float -> float)
  | Mix
  | Count
  | Nth

type t = { name : string; parameters : string list; doc : string; body : body }

let unit v =
  match Direction.of_vec3 v with
  | Some d -> (d :> Vec3.t)
  | None -> Vec3.make nan nan nan

let noise { Vec3.x; y; z } = Noise.noise x y z

let turbulence { Vec3.x; y; z } octaves =
  (* beyond 32 it stays the same *)
  Noise.turbulence x y z (int_of_float (Range.clamp octaves 0. 32.))

let hsv h s v = Hsv.color ~h ~s ~v

let row name parameters doc body =
  { name; parameters = String.split_on_char ' ' parameters; doc; body }

let all =
  [
    row "sin" "x" "the sine of x degrees" (Number Degrees.sin);
    row "cos" "x" "the cosine of x degrees" (Number Degrees.cos);
    row "tan" "x" "the tangent of x degrees" (Number Degrees.tan);
    row "asin" "x" "the angle from -90 to 90 degrees whose sine is x"
      (Number Arc.asin);
    row "acos" "x" "the angle from 0 to 180 degrees whose cosine is x"
      (Number Arc.acos);
    row "atan" "x" "the angle from -90 to 90 degrees whose tangent is x"
      (Number Arc.atan);
    row "atan2" "y x" "the angle in degrees between the x axis and (x, y)"
      (Number_2 Arc.atan2);
    row "sqrt" "x" "the square root of x" (Number sqrt);
    row "exp" "x" "e to the power of x" (Number Power.exp);
    row "log" "x" "the natural logarithm of x" (Number Power.log);
    row "abs" "x" "x without its sign" (Number abs_float);
    row "floor" "x" "the greatest whole number that is at most x"
      (Number floor);
    row "ceil" "x" "the least whole number that is at least x" (Number ceil);
    row "round" "x" "the whole number nearest to x, away from 0 of two"
      (Number Float.round);
    row "mod" "x d" "what is left when x is divided by d, never negative if d \
                     is positive" (Number_2 Range.modulo);
    row "min" "a b" "the lesser of a and b" (Number_2 Float.min);
    row "max" "a b" "the greater of a and b" (Number_2 Float.max);
    row "clamp" "x low high" "the number nearest to x from low to high"
      (Number_3 Range.clamp);
    row "smoothstep" "a b x" "0 where x is before a, 1 after b, and smooth \
                              between" (Number_3 Range.smoothstep);
    row "mix" "a b t" "(1 - t) a + t b, of numbers or vectors" Mix;
    row "length" "v" "the length of the vector v" (Of_vector Vec3.length);
    row "unit" "v" "the vector of length 1 along v" (Vector unit);
    row "dot" "u v" "the scalar product of u and v" (Of_vectors Vec3.dot);
    row "cross" "u v" "the vector product of u and v" (Vectors Vec3.cross);
    row "hsv" "h s v" "the colour of the hue at h degrees, the saturation s \
                       and the value v" (To_vector hsv);
    row "random" "k" "a number from 0 to 1, always the same for the same k"
      (Number Hash.random);
    row "noise" "p" "a number from -1 to 1 that waves smoothly with the point \
                     p" (Of_vector noise);
    row "turbulence" "p octaves" "the mean of so many noises, each twice as \
                                  fine as the one before it"
      (Vector_number turbulence);
    row "count" "list" "how many elements the list has" Count;
    row "nth" "list i" "element i of the list, counted from 0" Nth;
  ]
[@@ocamlformat "disable"]

let table =
  Hashtbl.of_seq (List.to_seq (List.map (fun row -> (row.name, row)) all))

let find name = Hashtbl.find_opt table name

let constants =
  [ ("pi", Float.pi, "the circumference of a circle over its diameter") ]

let usage { name; parameters; _ } =
  Printf.sprintf "%s(%s)" name (String.concat ", " parameters)
