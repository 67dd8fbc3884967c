type t = {
  points : float array;
  normals : float array;
  corners : int array;
  corner_normals : int array;
  faces : int array;
  places : int array;
  in_bytes : bool;
}

let none =
  {
    points = [||];
    normals = [||];
    corners = [||];
    corner_normals = [||];
    faces = [||];
    places = [||];
    in_bytes = false;
  }

let count { faces; _ } = Array.length faces

let place { places; in_bytes; _ } k =
  Printf.sprintf "%s %d" (if in_bytes then "byte" else "line") places.(k)
