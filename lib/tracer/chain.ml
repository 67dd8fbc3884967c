exception Too_long of { ray_depth : int }

let too_long ~ray_depth =
  Printf.sprintf
    "a chain of mirrored rays is too long for the stack that there is: make \
     raydepth, which is %d, smaller"
    ray_depth
