(* JSON, strictly: RFC 8259 in UTF-8, with these three restrictions, which make it smaller.  No key stands
   twice in an object, nothing is nested more than `deepest` deep, no integer has more than `longest` digits.
   Whatever is no such text raises Malformed, which says where and why.

     Int           an integer of at most 18 digits; Large: a longer one, its sign and its digits.
     Fraction      any other number, as it is written: it is never taken for an integer.
     String        in UTF-8, its escapes resolved.
   Lists of any length are read in constant stack. *)
type t =
  | Null | Bool of bool
  | Int of int | Large of bool * string | Fraction of string
  | String of string | List of t list | Object of (string * t) list

exception Malformed of string

let deepest = 500
let longest = 4300
let malformed why = raise (Malformed why)

(* the number of bytes of the character that begins at i; 0: no character in UTF-8 begins there *)
let width text i =
  let length = String.length text in
  let byte j = if j < length then Char.code text.[j] else 0 in
  let follows j = byte j land 0xC0 = 0x80 in
  let first = byte i and second = byte (i + 1) in
  let low = match first with 0xE0 -> 0xA0 | 0xF0 -> 0x90 | _ -> 0x80
  and high = match first with 0xED -> 0x9F | 0xF4 -> 0x8F | _ -> 0xBF in
  let fits = low <= second && second <= high in
  if first < 0x80 then 1
  else if first < 0xC2 then 0
  else if first < 0xE0 then if follows (i + 1) then 2 else 0
  else if first < 0xF0 then if fits && follows (i + 2) then 3 else 0
  else if first < 0xF5 then if fits && follows (i + 2) && follows (i + 3) then 4 else 0
  else 0

(* the character with this number, which may be half of a pair, in UTF-8 *)
let add_character out code =
  let add n = Buffer.add_char out (Char.chr n) in
  let rest shift = add (0x80 lor ((code lsr shift) land 0x3F)) in
  if code < 0x80 then add code
  else if code < 0x800 then (add (0xC0 lor (code lsr 6)); rest 0)
  else if code < 0x10000 then (add (0xE0 lor (code lsr 12)); rest 6; rest 0)
  else (add (0xF0 lor (code lsr 18)); rest 12; rest 6; rest 0)

let parse line =
  let length = String.length line in
  let at = ref 0 in
  let fail expected = malformed (Printf.sprintf "column %d: %s expected" (!at + 1) expected) in
  let peek () = if !at < length then line.[!at] else '\000' in
  let rec blank () = match peek () with ' ' | '\t' | '\r' | '\n' -> incr at; blank () | _ -> () in
  let expect c = if !at < length && peek () = c then incr at else fail (Printf.sprintf "'%c'" c) in
  let word w value =
    let n = String.length w in
    if !at + n <= length && String.sub line !at n = w then (at := !at + n; value) else fail w in
  let digits () =
    let start = !at in
    while (match peek () with '0' .. '9' -> true | _ -> false) do incr at done;
    if !at = start then fail "a digit" in
  let number () =
    let start = !at in
    let negative = peek () = '-' in
    if negative then incr at;
    let first = !at in
    if peek () = '0' then incr at else digits ();
    let whole = String.sub line first (!at - first) in
    let integer = ref true in
    if peek () = '.' then (integer := false; incr at; digits ());
    (match peek () with
     | 'e' | 'E' ->
         integer := false; incr at;
         (match peek () with '+' | '-' -> incr at | _ -> ());
         digits ()
     | _ -> ());
    if not !integer then Fraction (String.sub line start (!at - start))
    else if String.length whole > longest then
      malformed (Printf.sprintf "column %d: an integer of more than %d digits" (start + 1) longest)
    else if String.length whole > 18 then Large (negative, whole)
    else Int ((if negative then -1 else 1) * int_of_string whole) in
  let hexadecimal () =
    let value = ref 0 in
    for _ = 1 to 4 do
      let digit = match peek () with
        | '0' .. '9' as c -> Char.code c - Char.code '0'
        | 'a' .. 'f' as c -> Char.code c - Char.code 'a' + 10
        | 'A' .. 'F' as c -> Char.code c - Char.code 'A' + 10
        | _ -> fail "a hexadecimal digit" in
      value := 16 * !value + digit; incr at
    done;
    !value in
  let escape out =
    let plain c = incr at; Buffer.add_char out c in
    match peek () with
    | '"' | '\\' | '/' as c -> plain c
    | 'b' -> plain '\b' | 'f' -> plain '\012' | 'n' -> plain '\n' | 'r' -> plain '\r' | 't' -> plain '\t'
    | 'u' ->
        incr at;
        let high = hexadecimal () in
        let pair = 0xD800 <= high && high < 0xDC00 && !at + 1 < length && String.sub line !at 2 = "\\u" in
        if not pair then add_character out high
        else begin
          let back = !at in
          at := !at + 2;
          let low = hexadecimal () in
          if 0xDC00 <= low && low < 0xE000 then
            add_character out (0x10000 + ((high - 0xD800) lsl 10) + (low - 0xDC00))
          else (at := back; add_character out high)
        end
    | _ -> fail "an escape" in
  let text () =
    expect '"';
    let out = Buffer.create 16 in
    let rec go () =
      if !at >= length then fail "the end of a string"
      else match line.[!at] with
        | '"' -> incr at
        | '\\' -> incr at; escape out; go ()
        | c when c < ' ' -> fail "no control character"
        | _ ->
            let n = width line !at in
            if n = 0 then fail "UTF-8";
            Buffer.add_substring out line !at n;
            at := !at + n; go () in
    go (); Buffer.contents out in
  let rec value depth =
    blank ();
    if depth > deepest then
      malformed (Printf.sprintf "column %d: nested more than %d deep" (!at + 1) deepest);
    match peek () with
    | '{' -> incr at; object_of (items '}' (fun () ->
        blank (); let key = text () in blank (); expect ':'; (key, value (depth + 1))))
    | '[' -> incr at; List (items ']' (fun () -> value (depth + 1)))
    | '"' -> String (text ())
    | 'n' -> word "null" Null
    | 't' -> word "true" (Bool true)
    | 'f' -> word "false" (Bool false)
    | '-' | '0' .. '9' -> number ()
    | _ -> fail "a value"
  and items : 'a. char -> (unit -> 'a) -> 'a list = fun close item ->
    blank ();
    if !at < length && peek () = close then (incr at; [])
    else
      let rec more taken =
        let taken = item () :: taken in
        blank ();
        if peek () = ',' then (incr at; more taken) else (expect close; List.rev taken) in
      more []
  and object_of pairs =
    let seen = Hashtbl.create 8 in
    List.iter (fun (key, _) ->
      if Hashtbl.mem seen key then malformed "a key stands twice in one object"
      else Hashtbl.add seen key ()) pairs;
    Object pairs in
  let result = value 0 in
  blank ();
  if !at < length then fail "the end of the line";
  result

let field key = function Object items -> (try List.assoc key items with Not_found -> Null) | _ -> Null
let int = function Int n -> n | _ -> malformed "an integer expected"
let list of_item = function List l -> List.rev (List.rev_map of_item l) | _ -> malformed "a list expected"
let ints = list int

(* an integer modulo a positive number; None: it is none *)
let modulo n = function
  | Int k -> Some (((k mod n) + n) mod n)
  | Large (negative, digits) ->
      let rest = String.fold_left (fun r c -> (10 * r + Char.code c - Char.code '0') mod n) 0 digits in
      Some (if negative then (n - rest) mod n else rest)
  | _ -> None

let show l = "[" ^ String.concat "," (List.rev (List.rev_map string_of_int l)) ^ "]"

(* a text in ASCII, as JSON: any other byte, which may be none of a character, is shown as a question mark *)
let quote text =
  let out = Buffer.create (String.length text + 2) in
  Buffer.add_char out '"';
  String.iter (function
    | '"' -> Buffer.add_string out "\\\"" | '\\' -> Buffer.add_string out "\\\\"
    | c when c < ' ' -> Buffer.add_string out (Printf.sprintf "\\u%04x" (Char.code c))
    | c when c > '~' -> Buffer.add_char out '?'
    | c -> Buffer.add_char out c) text;
  Buffer.add_char out '"';
  Buffer.contents out
