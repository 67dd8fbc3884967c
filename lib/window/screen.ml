type address = { host : string; display : int }

let address text =
  match String.rindex_opt text ':' with
  | None -> None
  | Some colon ->
      let number =
        String.sub text (colon + 1) (String.length text - colon - 1)
      in
      let display = List.hd (String.split_on_char '.' number) in
      let host = String.sub text 0 colon in
      let host = if host = "unix" then "" else host in
      Option.map (fun display -> { host; display }) (int_of_string_opt display)

let method_ = "MIT-MAGIC-COOKIE-1"

(* A file is entries: a family, and four strings with their lengths before. *)
let cookie ~display file =
  let rec find at =
    let field at =
      let length = String.get_uint16_be file at in
      (String.sub file (at + 2) length, at + 2 + length)
    in
    let _host, at = field (at + 2) in
    let number, at = field at in
    let name, at = field at in
    let secret, at = field at in
    if name = method_ && (number = "" || number = string_of_int display) then
      Some secret
    else find at
  in
  (* the end of the file is in the middle of the entry that is not there *)
  try find 0 with Invalid_argument _ -> None

let padded text = text ^ String.make (-String.length text land 3) '\000'

let request secret =
  let name = if secret = "" then "" else method_ in
  let head = Bytes.make 12 '\000' in
  Bytes.set head 0 'l';
  Bytes.set_uint16_le head 2 11;
  Bytes.set_uint16_le head 6 (String.length name);
  Bytes.set_uint16_le head 8 (String.length secret);
  Bytes.to_string head ^ padded name ^ padded secret

let size_in_reply body =
  try
    let vendor = String.get_uint16_le body 16 in
    let formats = String.get_uint8 body 21 in
    let screen = 32 + ((vendor + 3) land lnot 3) + (8 * formats) in
    Some
      ( String.get_uint16_le body (screen + 20),
        String.get_uint16_le body (screen + 22) )
  with Invalid_argument _ -> None

let our_cookie display =
  let path =
    match Sys.getenv_opt "XAUTHORITY" with
    | Some path -> Some path
    | None ->
        Option.map
          (fun home -> Filename.concat home ".Xauthority")
          (Sys.getenv_opt "HOME")
  in
  match
    Option.map (fun path -> In_channel.(with_open_bin path input_all)) path
  with
  | Some file -> Option.value (cookie ~display file) ~default:""
  | None | (exception Sys_error _) -> ""

let seconds_to_answer = 2.

let talk { host; display } =
  let family, addresses =
    if host = "" then
      let path = Printf.sprintf "/tmp/.X11-unix/X%d" display in
      (Unix.PF_UNIX, [ Unix.ADDR_UNIX path; ADDR_UNIX ("\000" ^ path) ])
    else
      ( PF_INET,
        List.map
          (fun address -> Unix.ADDR_INET (address, 6000 + display))
          (Array.to_list (Unix.gethostbyname host).h_addr_list) )
  in
  let try_one address =
    let socket = Unix.socket ~cloexec:true family SOCK_STREAM 0 in
    Fun.protect ~finally:(fun () -> Unix.close socket) @@ fun () ->
    Unix.setsockopt_float socket SO_RCVTIMEO seconds_to_answer;
    Unix.setsockopt_float socket SO_SNDTIMEO seconds_to_answer;
    Unix.connect socket address;
    let channel = Unix.in_channel_of_descr socket in
    let sent = request (our_cookie display) in
    ignore (Unix.write_substring socket sent 0 (String.length sent));
    let head = Option.get (In_channel.really_input_string channel 8) in
    let length = 4 * String.get_uint16_le head 6 in
    if head.[0] <> '\001' then None
    else
      Option.bind (In_channel.really_input_string channel length) size_in_reply
  in
  List.find_map
    (fun address ->
      try try_one address
      with
      | Unix.Unix_error _ | Sys_error _ | Sys_blocked_io | Invalid_argument _
      ->
        None)
    addresses

let size () =
  match Option.bind (Sys.getenv_opt "DISPLAY") address with
  | None -> None
  | Some address -> ( try talk address with Not_found -> None)
