type t = { left : int; top : int; width : int; height : int }

let side = 16
let along length = (length + side - 1) / side
let count ~width ~height = along width * along height

let nth ~width ~height number =
  let left = number mod along width * side
  and top = number / along width * side in
  {
    left;
    top;
    width = Int.min side (width - left);
    height = Int.min side (height - top);
  }
