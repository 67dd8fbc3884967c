open Raylab_tracer

type t = {
  width : int;
  height : int;
  label : string option;
  iter : lowest_first:bool -> (bytes -> int -> int -> unit) -> unit;
}

let of_picture picture =
  let rgb = Picture.to_rgb picture in
  {
    width = Picture.width picture;
    height = Picture.height picture;
    label = None;
    iter = (fun ~lowest_first:_ f -> f rgb 0 (Bytes.length rgb));
  }
