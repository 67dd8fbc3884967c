open Raylab_geometry
open Raylab_scene

let pf = Printf.sprintf
let canvas = [ "canvWidth"; "canvHeight"; "depth" ]

(* {1 Which settings there are} *)

let list words =
  match List.rev words with
  | last :: (_ :: _ as before) ->
      String.concat ", " (List.rev before) ^ " and " ^ last
  | _ -> String.concat "" words

let tell_missing findings ~stop missing advice =
  if missing <> [] then
    Findings.error findings stop ~advice
      (pf "the header lacks %s" (String.concat ", " missing))

let tell findings ~seen ~stop =
  let is_seen word = List.mem_assoc word seen in
  let missing = List.filter (fun word -> not (is_seen word)) in
  let sizes = missing [ "imWidth"; "imHeight" ] in
  let written = List.filter is_seen canvas in
  match List.assoc_opt "fov" seen with
  | Some span ->
      tell_missing findings ~stop sizes
        "every scene says by imWidth and imHeight how large its picture is";
      if written <> [] then
        Findings.error findings span
          (pf "fov stands beside %s, and both say how much one sees"
             (list written))
          ~advice:(pf "remove fov, or remove %s" (list written));
      if not (is_seen "eye") then
        Findings.error findings span
          "fov needs eye, the point from which the angle is seen"
          ~advice:"add eye and a point, such as eye 0 0 -4"
  | None when written = [] && is_seen "eye" ->
      tell_missing findings ~stop
        (sizes @ [ "fov (or canvWidth, canvHeight and depth)" ])
        "fov says how wide the view is, in degrees, such as fov 60"
  | None ->
      tell_missing findings ~stop
        (sizes @ missing canvas)
        "every scene starts with imWidth, imHeight, canvWidth, canvHeight and \
         depth, each followed by a number"

(* {1 How it looks} *)

(* The first of [words] that is written, where an error of them is told. *)
let at ~seen words = List.find_map (fun word -> List.assoc_opt word seen) words

let point { Vec3.x; y; z } =
  String.concat " " (List.map (Format.asprintf "%a" Number.pp) [ x; y; z ])

let other_up ({ up; _ } : Settings.t) =
  let { Vec3.x; y; z } = Option.value up ~default:Viewpoint.default_up in
  let is_along_z = abs_float z >= abs_float x +. abs_float y in
  if is_along_z then "up 0 1 0" else "up 0 0 1"

let problem ~seen (s : Settings.t) : Viewpoint.problem -> _ = function
  | At_the_eye ->
      let place =
        point (Option.value s.look_at ~default:Viewpoint.default_look_at)
      in
      let message =
        match (s.eye, s.look_at) with
        | Some _, Some _ -> pf "eye and lookAt are the same point"
        | Some _, None ->
            pf
              "eye is %s, the point at which it looks unless lookAt says \
               otherwise"
              place
        | None, _ ->
            pf "lookAt is %s, where the eye is unless eye says otherwise" place
      in
      (at ~seen [ "lookAt"; "eye" ], message, "give the other another point")
  | Along_up ->
      ( at ~seen [ "up"; "lookAt"; "eye" ],
        "the eye looks along up, so that no direction is up in the picture",
        pf "give up another direction, such as %s" (other_up s) )

let tell_view findings ~seen (s : Settings.t) =
  let tell (span, message, advice) =
    Option.iter (fun span -> Findings.error findings span message ~advice) span
  in
  match Settings.viewpoint s with
  | None -> ()
  | Some (Error found) -> tell (problem ~seen s found)
  | Some (Ok _) -> (
      try ignore (Settings.camera s : Camera.t option)
      with Invalid_argument _ ->
        tell
          ( at ~seen [ "fov" ],
            "the canvas under this angle leaves the range of numbers",
            "give another angle, or another point for eye or lookAt" ))
