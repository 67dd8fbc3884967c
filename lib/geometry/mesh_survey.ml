type normals = Outward | Inward | Along of Direction.t | Anyhow

type t = {
  triangles : int;
  box : Box3.t;
  opening : string option;
  normals : normals;
}

let of_volume volume =
  if volume > 0. then Outward else if volume < 0. then Inward else Anyhow

(* Most of the area of what is open may look one way, as that of hills does; else
   it may turn away from the middle, as that of a cup does. *)
let of_open mesh =
  let facets = Mesh.facets mesh in
  let sum, whole = Mesh_edges.area facets in
  match Direction.of_vec3 sum with
  | Some direction when Vec3.length sum > 0.5 *. whole -> Along direction
  | _ ->
      let apex = Box3.centre (Mesh.box mesh) in
      of_volume (Mesh_edges.volume facets ~apex)

let make mesh =
  {
    triangles = Facets.count (Mesh.facets mesh);
    box = Mesh.box mesh;
    opening = Mesh.opening mesh;
    normals =
      (if Mesh.is_closed mesh then of_volume (Mesh.volume mesh)
       else of_open mesh);
  }

let to_string { triangles; box; opening; normals } =
  let mostly = if opening = None then "" else "most of " in
  Format.asprintf "%d triangle%s from %a, %s; %s" triangles
    (if triangles = 1 then "" else "s")
    Box3.pp box
    (match opening with
    | None -> "closed"
    | Some opening -> "open: " ^ opening)
    (match normals with
    | Outward -> mostly ^ "its normals point outward"
    | Inward -> mostly ^ "its normals point inward"
    | Along direction ->
        Format.asprintf "%sits normals point along %a" mostly Direction.pp
          direction
    | Anyhow -> "its normals point anyhow")
