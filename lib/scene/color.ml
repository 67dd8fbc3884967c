open Raylab_geometry

type t = { r : float; g : float; b : float }

let[@inline] make r g b = { r; g; b }
let black = make 0. 0. 0.
let white = make 1. 1. 1.
let red = make 1. 0. 0.
let green = make 0. 1. 0.
let blue = make 0. 0. 1.
let cyan = make 0. 1. 1.
let magenta = make 1. 0. 1.
let yellow = make 1. 1. 0.

let names =
  [
    ("black", black);
    ("white", white);
    ("red", red);
    ("green", green);
    ("blue", blue);
    ("cyan", cyan);
    ("magenta", magenta);
    ("yellow", yellow);
    ("grey", make 0.5 0.5 0.5);
    ("gray", make 0.5 0.5 0.5);
    ("orange", make 1. 0.5 0.);
    ("brown", make 0.5 0.25 0.1);
    ("pink", make 1. 0.6 0.75);
    ("purple", make 0.5 0. 0.5);
    ("gold", make 1. 0.78 0.3);
    ("silver", make 0.75 0.75 0.78);
  ]

let[@inline] add a b = { r = a.r +. b.r; g = a.g +. b.g; b = a.b +. b.b }
let[@inline] scale k c = { r = k *. c.r; g = k *. c.g; b = k *. c.b }
let[@inline] multiply a b = { r = a.r *. b.r; g = a.g *. b.g; b = a.b *. b.b }
let largest c = Float.max c.r (Float.max c.g c.b)

let luminance c =
  (* rounding may carry the sum of the largest doubles over the edge *)
  Float.min max_float ((0.2126 *. c.r) +. (0.7152 *. c.g) +. (0.0722 *. c.b))

let to_bytes c =
  (Level.of_channel c.r, Level.of_channel c.g, Level.of_channel c.b)

let equal a b = a.r = b.r && a.g = b.g && a.b = b.b

let require name c =
  Number.require Non_negative (name ^ "'s red") c.r;
  Number.require Non_negative (name ^ "'s green") c.g;
  Number.require Non_negative (name ^ "'s blue") c.b

let pp ppf { r; g; b } =
  Format.fprintf ppf "rgb %a %a %a" Number.pp r Number.pp g Number.pp b
