open Raylab_geometry

type t = { samples : int; exposure : float; srgb : bool }

let max_samples = 4096

let make ?(samples = 1) ?(exposure = 1.) ?(srgb = false) () =
  if samples < 1 || samples > max_samples then
    invalid_arg
      (Printf.sprintf "the samples of a pixel must be from 1 to %d, not %d"
         max_samples samples);
  Number.require Positive "the exposure" exposure;
  { samples; exposure; srgb }

let default = make ()

let with_samples samples { exposure; srgb; _ } =
  make ~samples ~exposure ~srgb ()

let with_exposure exposure { samples; srgb; _ } =
  make ~samples ~exposure ~srgb ()

let with_srgb srgb film = { film with srgb }

(* {1 Colours} *)

let[@inline] clamp v = if v >= 1. then 1. else if v > 0. then v else 0.

(* Most colours need nothing, and then nothing is allocated. *)
let[@inline] expose { exposure = k; _ } ({ Color.r; g; b } as c) =
  if k = 1. && r <= 1. && g <= 1. && b <= 1. then c
  else Color.make (clamp (k *. r)) (clamp (k *. g)) (clamp (k *. b))

let brightest = 255.5 /. 255.

let[@inline] over_exposed { exposure = k; _ } { Color.r; g; b } =
  k *. r > brightest || k *. g > brightest || k *. b > brightest

let channel { srgb; _ } v = if srgb then Srgb.encode v else v

let[@inline] encode { srgb; _ } ({ Color.r; g; b } as c) =
  if srgb then Color.make (Srgb.encode r) (Srgb.encode g) (Srgb.encode b)
  else c

let to_bytes film c = Color.to_bytes (encode film c)

(* {1 As a whole} *)

let equal (a : t) b = a = b

let pp ppf { samples; exposure; srgb } =
  Format.fprintf ppf "samples %d, exposure %a%s" samples Number.pp exposure
    (if srgb then ", srgb" else "")
