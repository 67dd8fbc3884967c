type t =
  | File of string * Unix.stats
  | Nothing of string
  | Descriptor of int
  | Stream of string

let fail error path = raise (Unix.Unix_error (error, "open", path))

(* As many as Linux follows. *)
let most_links = 40

let beside path target =
  if Filename.is_relative target then
    Filename.concat (Filename.dirname path) target
  else target

let rec follow links path =
  match Descriptor.of_path path with
  | Some (Own n) -> Descriptor n
  | Some Foreign -> Stream path
  | None -> (
      match Unix.lstat path with
      | { st_kind = S_LNK; _ } when links = 0 -> fail ELOOP path
      | { st_kind = S_LNK; _ } ->
          follow (links - 1) (beside path (Unix.readlink path))
      | { st_kind = S_REG; _ } as stats -> File (path, stats)
      | { st_kind = S_DIR; _ } -> fail EISDIR path
      | { st_kind = S_SOCK; _ } -> fail ENXIO path
      | { st_kind = S_CHR | S_BLK | S_FIFO; _ } -> Stream path
      | exception Unix.Unix_error (ENOENT, _, _) ->
          if String.ends_with ~suffix:"/" path then fail ENOTDIR path
          else Nothing path)

let of_path path = follow most_links path

let has_name path =
  path <> "-"
  &&
  match of_path path with
  | File _ | Nothing _ | (exception Unix.Unix_error _) -> true
  | Descriptor _ | Stream _ -> false

let is_standard number path =
  path = "-"
  ||
  match of_path path with
  | Descriptor n -> n = number
  | File _ | Nothing _ | Stream _ | (exception Unix.Unix_error _) -> false

let is_standard_input = is_standard 0
let is_standard_output = is_standard 1
