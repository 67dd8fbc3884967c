type t = {
  points : float array;
  normals : float array;
  corners : int array;
  corner_normals : int array;
  faces : int array;
  places : int array;
}

let none =
  {
    points = [||];
    normals = [||];
    corners = [||];
    corner_normals = [||];
    faces = [||];
    places = [||];
  }

let count { faces; _ } = Array.length faces
