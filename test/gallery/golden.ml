(* Scenes and their golden pictures: those of the gallery, and those of the
   manual page of the scene language. At the top of the repository:

   golden compare          is what the tests do
   golden accept [NAME...] makes new golden pictures of these scenes, or of all
                           whose pictures have changed *)

open Raylab_scene
open Raylab_language
open Raylab_tracer
open Raylab_picture

(* {1 Places} *)

(* Large enough to see what there is, small enough for a repository. *)
let width = 160

let small (camera : Camera.t) =
  let shape = float_of_int camera.height /. float_of_int camera.width in
  let height = Int.max 1 (Float.to_int (Float.round (float width *. shape))) in
  Camera.with_size ~width ~height camera

type place = {
  scenes : string;  (** where the scenes are *)
  size : Camera.t -> Camera.t;  (** of the pictures *)
  goldens : string;  (** where these are *)
  index : string;  (** the page that has to speak of each of them *)
  link : string -> string;  (** how it does, by a scene's name *)
}

let gallery =
  {
    scenes = "scenes";
    size = small;
    goldens = "test/gallery";
    index = "test/gallery/README.md";
    link = (fun name -> Printf.sprintf "[%s](%s.png)" name name);
  }

let manual =
  {
    scenes = "doc/language";
    size = Fun.id;
    goldens = "doc/language";
    index = "doc/language.md";
    link = (fun name -> Printf.sprintf "[%s]: language/%s.png" name name);
  }

let places = [ gallery; manual ]

(* Where [compare] puts the pictures that are not as they were. *)
let news place = Filename.concat place.goldens "new"
let scene_file place name = Filename.concat place.scenes (name ^ ".scene")
let picture_file dir name = Filename.concat dir (name ^ ".png")
let golden_file place = picture_file place.goldens

let names dir extension =
  Sys.readdir dir |> Array.to_list
  |> List.filter (fun file -> Filename.extension file = extension)
  |> List.map Filename.remove_extension
  |> List.sort String.compare

(* Tells what is wrong, and goes on: all of it is wanted at once. *)
let failed = ref false

let fail format =
  failed := true;
  Printf.eprintf (format ^^ "\n%!")

(* {1 Rendering} *)

let render place name =
  match
    Scene_file.load ~access:Test_files.Nearby.access (scene_file place name)
  with
  | Ok scene ->
      let scene = Scene.with_camera (place.size scene.camera) scene in
      Some (fst (Render.picture (Prepared.make scene)))
  | Error errors ->
      List.iter
        (fun error -> fail "%s" (Format.asprintf "%a" Scene_error.pp error))
        errors;
      None

let save path picture =
  match Picture_file.save Png ~path picture with
  | Ok _ ->
      (* in full, since the tests run in the build directory *)
      Printf.eprintf "wrote %s\n%!" (Filename.concat (Sys.getcwd ()) path)
  | Error message -> fail "%s" message

(* {1 Comparing} *)

(* PNG files are compared by what they show: other versions of zlib may pack it
   in another way. *)
let load_golden place name ~width ~height =
  In_channel.with_open_bin (golden_file place name) (fun channel ->
      Png_file.read channel ~width ~height)

type difference = { pixels : int; most : int; x : int; y : int }

let pixel rgb k =
  let byte i = Bytes.get_uint8 rgb ((3 * k) + i) in
  (byte 0, byte 1, byte 2)

let distance (r, g, b) (r', g', b') =
  Int.max (Int.abs (r - r')) (Int.max (Int.abs (g - g')) (Int.abs (b - b')))

(* [difference ~width a b] is how far the pixels of [a] and [b] are apart, and
   the first place where they are. *)
let difference ~width a b =
  let add found k =
    match (distance (pixel a k) (pixel b k), found) with
    | 0, _ -> found
    | d, None -> Some { pixels = 1; most = d; x = k mod width; y = k / width }
    | d, Some f ->
        Some { f with pixels = f.pixels + 1; most = Int.max f.most d }
  in
  Seq.fold_left add None (Seq.init (Bytes.length a / 3) Fun.id)

let complaint place name picture =
  let width = Picture.width picture and height = Picture.height picture in
  if not (Sys.file_exists (golden_file place name)) then
    Some "it has no golden picture"
  else
    match load_golden place name ~width ~height with
    | None ->
        Some
          (Printf.sprintf "%s is no PNG of %d x %d pixels that raylab wrote"
             (golden_file place name) width height)
    | Some old ->
        let rgb = Picture.to_rgb picture in
        let tell { pixels; most; x; y } =
          let k = (y * width) + x in
          let show (r, g, b) = Printf.sprintf "%d %d %d" r g b in
          Printf.sprintf
            "%d of %d pixels differ, by up to %d of 255; the first is (%d, \
             %d), which is %s and was %s"
            pixels (width * height) most x y
            (show (pixel rgb k))
            (show (pixel old k))
        in
        Option.map tell (difference ~width rgb old)

let compare_one place name =
  let check picture =
    match complaint place name picture with
    | None -> ()
    | Some complaint ->
        fail "%s: %s" (scene_file place name) complaint;
        if not (Sys.file_exists (news place)) then Sys.mkdir (news place) 0o777;
        save (picture_file (news place) name) picture;
        Printf.eprintf
          "Look at it. If it is right, make it the golden picture:\n\
          \  dune exec test/gallery/golden.exe accept %s\n\
           %!"
          name
  in
  Option.iter check (render place name)

let contains text part =
  let length = String.length part in
  let is_at i = String.sub text i length = part in
  Seq.exists is_at (Seq.init (String.length text - length + 1) Fun.id)

let check_index place text name =
  let link = place.link name in
  if not (contains text link) then
    fail "%s: %s says nothing of its picture: add %s" (scene_file place name)
      place.index link

let compare_all place =
  let known = names place.scenes ".scene" in
  List.iter (compare_one place) known;
  List.iter
    (check_index place
       (In_channel.with_open_bin place.index In_channel.input_all))
    known;
  List.iter
    (fun name ->
      if not (List.mem name known) then
        fail "%s: there is no %s; remove it" (golden_file place name)
          (scene_file place name))
    (names place.goldens ".png")

(* {1 Accepting} *)

(* What has not changed keeps its file, however it is packed. *)
let accept place name =
  let check picture =
    if complaint place name picture <> None then
      save (golden_file place name) picture
  in
  Option.iter check (render place name)

let accept_all place = List.iter (accept place) (names place.scenes ".scene")

let accept_named name =
  let has_it place = Sys.file_exists (scene_file place name) in
  match List.filter has_it places with
  | [] -> fail "there is no scene %s" name
  | places -> List.iter (fun place -> accept place name) places

let () =
  (match List.tl (Array.to_list Sys.argv) with
  | [ "compare" ] -> List.iter compare_all places
  | [ "accept" ] -> List.iter accept_all places
  | "accept" :: names -> List.iter accept_named names
  | _ -> fail "usage: golden compare | golden accept [NAME...]");
  if !failed then exit 1
