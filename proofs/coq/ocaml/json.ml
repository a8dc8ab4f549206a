(* JSON as the protocol needs it: integers, strings, arrays, objects, null, booleans; fractions are
   read as integers towards zero.  A line that is no JSON raises Malformed. *)
type t = Null | Bool of bool | Int of int | String of string | List of t list | Object of (string * t) list

exception Malformed of string

let parse line =
  let length = String.length line in
  let at = ref 0 in
  let fail expected = raise (Malformed (Printf.sprintf "column %d: %s expected" !at expected)) in
  let peek () = if !at < length then line.[!at] else '\000' in
  let rec blank () = match peek () with ' ' | '\t' | '\r' | '\n' -> incr at; blank () | _ -> () in
  let expect c = if peek () = c then incr at else fail (String.make 1 c) in
  let word w value =
    let n = String.length w in
    if !at + n <= length && String.sub line !at n = w then (at := !at + n; value) else fail w in
  let number () =
    let start = !at in
    let digits () = while (match peek () with '0' .. '9' -> true | _ -> false) do incr at done in
    if peek () = '-' then incr at;
    digits ();
    if !at = start || line.[!at - 1] = '-' then fail "a number";
    let whole = int_of_string (String.sub line start (!at - start)) in
    if peek () = '.' then (incr at; digits ());
    Int whole in
  let text () =
    expect '"';
    let out = Buffer.create 16 in
    let rec go () = match peek () with
      | '"' -> incr at
      | '\\' ->
          incr at;
          (match peek () with
           | 'n' -> Buffer.add_char out '\n' | 't' -> Buffer.add_char out '\t'
           | 'u' -> at := !at + 4; Buffer.add_char out '?'
           | c -> Buffer.add_char out c);
          incr at; go ()
      | _ when !at >= length -> fail "the end of a string"
      | c -> Buffer.add_char out c; incr at; go () in
    go (); Buffer.contents out in
  let rec value () =
    blank ();
    match peek () with
    | '{' -> incr at; Object (items '}' (fun () ->
        blank (); let key = text () in blank (); expect ':'; (key, value ())))
    | '[' -> incr at; List (items ']' value)
    | '"' -> String (text ())
    | 'n' -> word "null" Null
    | 't' -> word "true" (Bool true)
    | 'f' -> word "false" (Bool false)
    | _ -> number ()
  and items : 'a. char -> (unit -> 'a) -> 'a list = fun close item ->
    blank ();
    if peek () = close then (incr at; [])
    else
      let rec more () =
        let x = item () in
        blank ();
        if peek () = ',' then (incr at; x :: more ()) else (expect close; [x]) in
      more () in
  let result = value () in
  blank ();
  if !at < length then fail "the end of the line";
  result

let field key = function Object items -> (try List.assoc key items with Not_found -> Null) | _ -> Null
let int = function Int n -> n | _ -> raise (Malformed "an integer expected")
let ints = function List l -> List.map int l | _ -> raise (Malformed "a list expected")
let show l = "[" ^ String.concat "," (List.map string_of_int l) ^ "]"
let quote text =
  let out = Buffer.create (String.length text + 2) in
  Buffer.add_char out '"';
  String.iter (function
    | '"' -> Buffer.add_string out "\\\"" | '\\' -> Buffer.add_string out "\\\\"
    | c when c < ' ' -> Buffer.add_string out (Printf.sprintf "\\u%04x" (Char.code c))
    | c -> Buffer.add_char out c) text;
  Buffer.add_char out '"';
  Buffer.contents out
