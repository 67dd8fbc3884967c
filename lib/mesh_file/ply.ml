open Ply_header

let name_of = function Scalar { name; _ } | List { name; _ } -> name

let has element name =
  List.exists (fun p -> name_of p = name) element.properties

(* Rows of which nobody asks. *)
let skip rows = function
  | Scalar { item; _ } -> ignore (Ply_rows.next rows item : float)
  | List { count; item; _ } ->
      for _ = 1 to Ply_rows.next_int rows count do
        ignore (Ply_rows.next rows item : float)
      done

let read_rows rows element read_row =
  Ply_rows.check rows element;
  if element.properties <> [] then
    for _ = 1 to element.count do
      Ply_rows.start_row rows;
      read_row ();
      Ply_rows.end_row rows
    done

(* {1 Points} *)

let slots = [ ("x", 0); ("y", 1); ("z", 2); ("nx", 3); ("ny", 4); ("nz", 5) ]

let read_points rows mesh ~has_normals element =
  List.iter
    (fun axis ->
      if not (has element axis) then
        Fault.fail element.declared "the vertices have no property %s" axis)
    [ "x"; "y"; "z" ];
  let values = Array.make (List.length slots) 0. in
  let take = function
    | List _ as property -> skip rows property
    | Scalar { name; item } -> (
        let x = Ply_rows.next rows item in
        match List.assoc_opt name slots with
        | Some slot -> values.(slot) <- x
        | None -> ())
  in
  read_rows rows element (fun () ->
      let place = Ply_rows.place rows in
      List.iter take element.properties;
      Builder.point mesh place values.(0) values.(1) values.(2);
      if has_normals then
        Builder.normal mesh place values.(3) values.(4) values.(5))

(* {1 Faces} *)

let is_corners = function
  | List { name = "vertex_indices" | "vertex_index"; _ } -> true
  | _ -> false

let read_faces rows mesh ~has_normals element =
  if not (List.exists is_corners element.properties) then
    Fault.fail element.declared "the faces have no list vertex_indices";
  let corner item =
    let point = Ply_rows.next_int rows item in
    Builder.corner mesh ~point ~normal:(if has_normals then point else -1)
  in
  let take property =
    match property with
    | List { count; item; _ } when is_corners property ->
        for _ = 1 to Ply_rows.next_int rows count do
          corner item
        done
    | property -> skip rows property
  in
  read_rows rows element (fun () ->
      let place = Ply_rows.place rows in
      List.iter take element.properties;
      Builder.end_face mesh place)

(* {1 The file} *)

let is_colour property =
  List.mem (name_of property) [ "red"; "diffuse_red"; "r" ]

let read_element rows mesh ~has_normals element =
  if List.exists is_colour element.properties then
    Builder.unused mesh element.declared "colours";
  match element.name with
  | "vertex" -> read_points rows mesh ~has_normals element
  | "face" -> read_faces rows mesh ~has_normals element
  | name ->
      if element.count > 0 then
        Builder.unused mesh element.declared
          (Printf.sprintf "elements called '%s'"
             (Raylab_source.Printable.text name));
      read_rows rows element (fun () ->
          List.iter (skip rows) element.properties)

let read ~most bytes =
  let header = Ply_header.read bytes in
  let rows = Ply_rows.start header bytes
  and mesh = Builder.create ~most ~counted_from:0 in
  let gives_normals element =
    element.name = "vertex" && List.for_all (has element) [ "nx"; "ny"; "nz" ]
  in
  let has_normals = List.exists gives_normals header.elements in
  List.iter (read_element rows mesh ~has_normals) header.elements;
  mesh
