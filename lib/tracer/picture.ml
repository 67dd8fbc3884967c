open Raylab_scene

type t = { width : int; height : int; rgb : Bytes.t }

let unset ~width ~height =
  if width < 1 || height < 1 then
    invalid_arg (Printf.sprintf "a picture of %d x %d pixels" width height);
  (* [3 * width * height] might be more than an integer holds *)
  if height > Sys.max_string_length / 3 / width then
    invalid_arg
      (Printf.sprintf "a picture of %d x %d pixels is too large" width height);
  { width; height; rgb = Bytes.create (3 * width * height) }

let create ~width ~height =
  let picture = unset ~width ~height in
  Bytes.fill picture.rgb 0 (Bytes.length picture.rgb) '\000';
  picture

let width picture = picture.width
let height picture = picture.height

let offset { width; height; _ } ~x ~y =
  if x < 0 || x >= width || y < 0 || y >= height then
    invalid_arg
      (Printf.sprintf "pixel (%d, %d) of a picture of %d x %d pixels" x y width
         height);
  3 * ((y * width) + x)

let set picture ~x ~y (color : Color.t) =
  let at = offset picture ~x ~y in
  Bytes.set_uint8 picture.rgb at (Level.of_channel color.r);
  Bytes.set_uint8 picture.rgb (at + 1) (Level.of_channel color.g);
  Bytes.set_uint8 picture.rgb (at + 2) (Level.of_channel color.b)

let get picture ~x ~y =
  let at = offset picture ~x ~y in
  let byte k = Bytes.get_uint8 picture.rgb (at + k) in
  (byte 0, byte 1, byte 2)

let code picture ~x ~y =
  let at = offset picture ~x ~y in
  (Bytes.get_uint16_be picture.rgb at lsl 8)
  lor Bytes.get_uint8 picture.rgb (at + 2)

let to_rgb picture = picture.rgb

let equal a b =
  a.width = b.width && a.height = b.height && Bytes.equal a.rgb b.rgb
