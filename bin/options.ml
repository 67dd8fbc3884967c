open Cmdliner
open Raylab_parallel
open Raylab_geometry
open Raylab_scene

let conv parse print ~docv =
  let parse text =
    Result.map_error (fun message -> `Msg message) (parse text)
  in
  Arg.conv ~docv (parse, print)

let natural text =
  if text <> "" && String.for_all (fun c -> '0' <= c && c <= '9') text then
    int_of_string_opt text
  else None

let pair separator text =
  match String.split_on_char separator text with
  | [ a; b ] -> (
      match (natural a, natural b) with
      | Some a, Some b -> Some (a, b)
      | _ -> None)
  | _ -> None

type view = {
  size : (int * int) option;
  grey : bool;
  samples : int option;
  exposure : float option;
  srgb : bool;
}

let size =
  let fits n = 1 <= n && n <= Camera.max_size in
  let parse text =
    match pair 'x' (String.lowercase_ascii text) with
    | Some (width, height) when fits width && fits height -> Ok (width, height)
    | _ ->
        Error
          (Printf.sprintf
             "'%s' is not a size: expected width and height in pixels, such \
              as 640x480"
             text)
  in
  conv parse ~docv:"WxH" (fun ppf (w, h) -> Format.fprintf ppf "%dx%d" w h)

let count what ~most ~docv =
  let parse text =
    match natural text with
    | Some n when 1 <= n && n <= most -> Ok n
    | _ ->
        Error
          (Printf.sprintf "'%s' is not a number of %s from 1 to %d" text what
             most)
  in
  conv parse ~docv Format.pp_print_int

let samples = count "samples" ~most:Film.max_samples ~docv:"N"

let exposure =
  let parse text =
    match float_of_string_opt text with
    | Some k when Number.broken Positive k = None -> Ok k
    | _ ->
        Error
          (Printf.sprintf
             "'%s' is not an exposure: expected a number greater than 0" text)
  in
  conv parse ~docv:"K" Number.pp

let view =
  let open Arg in
  let size =
    let doc =
      "Make the picture $(docv) pixels large, whatever the scene says. It \
       shows the same canvas, stretched if its proportions differ."
    in
    value & opt (some size) None & info [ "size" ] ~docv:"WxH" ~doc
  and grey =
    let doc =
      "Render in greyscale: take every colour of the scene by its luminance."
    in
    value & flag & info [ "grey"; "gray" ] ~doc
  and samples =
    let doc =
      "Take up to $(docv) samples of each pixel, whatever the scene says: as \
       many as the pixel needs. 1 makes edges of steps, 16 smooth ones."
    in
    value & opt (some samples) None & info [ "samples" ] ~docv:"N" ~doc
  and exposure =
    let doc =
      "Show every colour $(docv) times as bright, whatever the scene says."
    in
    value & opt (some exposure) None & info [ "exposure" ] ~docv:"K" ~doc
  and srgb =
    let doc =
      "Show colours by the sRGB curve, as screens expect light to be written. \
       Dark colours become brighter."
    in
    value & flag & info [ "srgb" ] ~doc
  in
  let make size grey samples exposure srgb =
    { size; grey; samples; exposure; srgb }
  in
  Term.(const make $ size $ grey $ samples $ exposure $ srgb)

let is_grey view = view.grey

let arguments { size; grey; samples; exposure; srgb } =
  let option name print = function
    | None -> []
    | Some value -> [ name; print value ]
  and flag name is_given = if is_given then [ name ] else [] in
  List.concat
    [
      option "--size" (fun (w, h) -> Printf.sprintf "%dx%d" w h) size;
      flag "--grey" grey;
      option "--samples" string_of_int samples;
      option "--exposure" Number.to_exact_string exposure;
      flag "--srgb" srgb;
    ]

let adjust_film { samples; exposure; srgb; _ } film =
  let change with_ value film =
    Option.fold value ~none:film ~some:(fun value -> with_ value film)
  in
  change Film.with_samples samples film
  |> change Film.with_exposure exposure
  |> if srgb then Film.with_srgb true else Fun.id

let adjust ({ size; grey; _ } as view) scene =
  let scene = if grey then Scene.greyscale scene else scene in
  let scene = Scene.with_film (adjust_film view scene.film) scene in
  match size with
  | None -> scene
  | Some (width, height) ->
      Scene.with_camera (Camera.with_size ~width ~height scene.camera) scene

let adjust_colored view = adjust { view with grey = false }

let distortion view { Scene.camera; _ } =
  let of_size (width, height) =
    let sized = Camera.with_size ~width ~height camera in
    match Proportions.distortion sized with
    | Some how when Proportions.distortion camera <> Some how ->
        Some
          (Printf.sprintf
             "--size %dx%d distorts the picture, which looks %s; %dx%d would \
              not"
             width height how width
             (Proportions.fitting_height sized))
    | _ -> None
  in
  Option.bind view.size of_size

let folder =
  let parse text =
    match Sys.is_directory text with
    | true -> Ok text
    | false -> Error (Printf.sprintf "'%s' is not a folder" text)
    | exception Sys_error _ -> Error (Printf.sprintf "there is no '%s'" text)
  in
  conv parse ~docv:"DIR" Format.pp_print_string

let allow =
  let doc =
    "Files that $(i,SCENE) includes may also be in the folder $(docv) or \
     below it, and not only in that of $(i,SCENE). It may be given several \
     times."
  in
  Arg.(value & opt_all folder [] & info [ "allow" ] ~docv:"DIR" ~doc)

let from_prompt =
  Arg.(value & flag & info [ "from-prompt" ] ~docs:Manpage.s_none)

let number_of_domains =
  count "domains" ~most:Parallel.max_domains ~docv:"DOMAINS"

let domains =
  let doc =
    "Render on $(docv) domains at once, by default one for each core. The \
     picture is the same, byte for byte."
  in
  Arg.(
    value
    & opt (some number_of_domains) None
    & info [ "j"; "domains" ] ~docv:"DOMAINS" ~doc)
