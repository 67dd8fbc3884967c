type t = { left : int; top : int; width : int; height : int }

let side = 16
let along ~side length = (length + side - 1) / side
let count ~side ~width ~height = along ~side width * along ~side height

let nth ~side ~width ~height number =
  let across = along ~side width in
  let left = number mod across * side and top = number / across * side in
  {
    left;
    top;
    width = Int.min side (width - left);
    height = Int.min side (height - top);
  }
