open Cmdliner
open Raylab_parallel
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

type view = { size : (int * int) option; grey : bool }

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
  in
  Term.(const (fun size grey -> { size; grey }) $ size $ grey)

let is_grey view = view.grey

let arguments { size; grey } =
  (match size with
  | None -> []
  | Some (width, height) -> [ "--size"; Printf.sprintf "%dx%d" width height ])
  @ if grey then [ "--grey" ] else []

let adjust { size; grey } scene =
  let scene = if grey then Scene.greyscale scene else scene in
  match size with
  | None -> scene
  | Some (width, height) ->
      Scene.with_camera (Camera.with_size ~width ~height scene.camera) scene

let warn view { Scene.camera; _ } =
  match view.size with
  | None -> ()
  | Some (width, height) -> (
      let sized = Camera.with_size ~width ~height camera in
      match Proportions.distortion sized with
      | Some how when Proportions.distortion camera <> Some how ->
          Command.say
            "warning: --size %dx%d distorts the picture, which looks %s; \
             %dx%d would not"
            width height how width
            (Proportions.fitting_height sized)
      | _ -> ())

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

let number_of_domains =
  let parse text =
    match natural text with
    | Some n when 1 <= n && n <= Parallel.max_domains -> Ok n
    | _ ->
        Error
          (Printf.sprintf "'%s' is not a number of domains from 1 to %d" text
             Parallel.max_domains)
  in
  conv parse ~docv:"DOMAINS" Format.pp_print_int

let domains =
  let doc =
    "Render on $(docv) domains at once, by default one for each core. The \
     picture is the same, byte for byte."
  in
  Arg.(
    value
    & opt (some number_of_domains) None
    & info [ "j"; "domains" ] ~docv:"DOMAINS" ~doc)
