open Raylab_geometry

type t = { aperture : float; focus : float option }

let make ?focus aperture =
  Number.require Non_negative "the aperture" aperture;
  Option.iter (Number.require Positive "the focus") focus;
  { aperture; focus }

let pinhole = make 0.
let is_open { aperture; _ } = aperture > 0.
let equal (a : t) b = a = b

let pp ppf { aperture; focus } =
  Format.fprintf ppf "aperture %a" Number.pp aperture;
  Option.iter (Format.fprintf ppf ", focus %a" Number.pp) focus
