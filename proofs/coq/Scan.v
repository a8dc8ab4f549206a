(* ---------------------------------------------------------------------------------------------
   An explorer for every sensor at v0 whose word is primitive and not blank.       Sections IV and VIII

   The letters seen on the way of a test may not tell where the door is.  So the robot scans a vertex: it
   goes out and back by each of its darts in turn, and has then seen the letter of each.  Before the first
   pass it scans v0, and knows from the letters how many darts clockwise the door is; at the end of a test it
   scans the vertex where it is, and the test matches if and only if the letters are those that S foretells.

     seen_by w o          of a percept with a bearing: the degree and the letter.
     scan n c letters     out and back by n darts, the next one first; c: the turn that is due.
     letters_from w n q   the letters of the n darts of v0 from the next one on, if the door is q darts
                          further.
     scanning w n, scanning_algorithm w pol   the lighthouse, n being the degree of v0, and the explorer,
                          which takes n from the first percept.
     letters_of y         what a scan that begins in y sees.
     scanned S f y        a scan in y sees what S foretells at f.

     scanned_iff          a scan matches if and only if the hypothesis is true.
     scanning_correct     the explorer, under every policy, with any budget of at least (1)+(2), a scan of
                          2 deg(v0) traversals for each test, 2 deg(v0) m^2 in all, and one at the start:
                          it stops within that, and is right.
     sufficient_iff_explored   a sensor at v0 suffices if and only if one explorer is right with it in all
                          worlds.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import Model Maps Percepts RootedMaps Codes Explorers Indistinguishable.
From Allworlds Require Import PartialMaps HypothesisTests.
From Allworlds Require Import Pass Cost Correctness Lighthouses Algorithm Queue Execution OnePass.
From Allworlds Require Import Refinement Policies Words Sensors OneBit.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Section Program.
Variable w : nat -> nat -> nat.

Definition seen_by (o : percept) : nat * nat := (o.1, if o.2 is Some b then w o.1 b else 0).

Fixpoint scan n c (letters : seq nat) : program (nat * nat) (seq nat) :=
  if n is n'.+1 then Go c.+1 (fun _ => Go 0 (fun o => scan n' 0 (rcons letters o.2))) else Return letters.

Definition letters_from n q := mkseq (fun i => w n ((q + (n - i.+1)) %% n)) n.

Definition scanning n : lighthouse (nat * nat) [eqType of nat] :=
  {| set_out := fun _ => bind (scan n 0 [::]) (fun letters =>
       Return (knowledge_at_v0 n (find (fun b => letters == letters_from n b) (iota 0 n)) 0));
     reads := id;
     foretells := seen_by;
     confirm := fun k f c => bind (scan n c [::]) (fun letters =>
       Return (letters == letters_from n (odflt 0 (expected_percept (bearing0 k) (known_map k) f).2),
               opposite (degree_in (known_map k) f.1) n)) |}.
Definition scanning_algorithm pol : explorer (nat * nat) numbered_map :=
  fun seen => explorer_by (scanning (head (0, 0) seen).1) pol seen.

(* the letters of a primitive word tell where the door is *)
Lemma letters_from_inj n q q' : primitive (word w n) -> q < n -> q' < n ->
  letters_from n q = letters_from n q' -> q = q'.
Proof.
move=> Pr qn qn' E; apply: (primitive_turn Pr qn qn') => c.
have n0 : 0 < n by exact: leq_ltn_trans qn.
have lt : n - (c %% n).+1 < n by rewrite ltn_subrL.
have := congr1 (fun s => nth 0 s (n - (c %% n).+1)) E; rewrite !nth_mkseq // subnSK ?ltn_pmod //.
by rewrite subKn ?(ltnW (ltn_pmod _ n0)) // !modnDmr ![_ + c]addnC.
Qed.
End Program.

(* ---- In a world ---- *)
Section InWorld.
Variables (w : nat -> nat -> nat) (W : lighthouse_world).
Local Notation v0 := (@start W).
Local Notation n := (degree v0).
Local Notation b := (first_bearing W).
Local Notation embedded := (@embedded W v0).
Local Notation phi := (@phi W v0).
Local Notation senses := (percept_by (at_v0 w) (W := W)).
Local Notation makes := (makes senses).
Hypothesis adequate_word : adequate (word w n).

Lemma seen_by_percept (d : W) : senses d = seen_by w (percept_of d).
Proof. by rewrite /percept_by letter_of_bearing. Qed.

Definition letters_of (y : W) := mkseq (fun i => at_v0 w pointed (iter i.+1 sigma y)) n.

Lemma scan_makes k c letters (d y : W) : due c d y -> exists z,
  makes (scan k c letters) d
    (letters ++ mkseq (fun i => at_v0 w pointed (iter i.+1 sigma y)) k) z (2 * k) /\
  due (if k is 0 then c else 0) z (iter k sigma y).
Proof.
elim: k c letters d y => [|k IH] c letters d y du.
  by exists d; rewrite cats0; split=> //; exact: makes_return.
have du' : due 0 (sigma y) (sigma y) by [].
have [z [A D]] := IH 0 (rcons letters (at_v0 w pointed (sigma y))) _ _ du'.
exists z; split; last by rewrite iterSr; case: (k) D.
have Y : motion 0 (motion c.+1 d) = sigma y by rewrite /motion /= alphaK du.
rewrite mulnS; apply: makes_go; apply: makes_go; rewrite Y /=.
move: A; rewrite cat_rcons; congr makes; congr (_ ++ _).
rewrite /mkseq [in RHS]/= -[in RHS]add1n iotaDl -map_comp /=; congr (_ :: _).
by apply: eq_map => i /=; rewrite -iterSr.
Qed.

Lemma letters_at_v0 (y : W) q : degree y = n -> iter q sigma y = pointed ->
  letters_of y = letters_from w n q.
Proof.
move=> D E; apply: (@eq_from_nth _ 0) => [|i]; rewrite !size_mkseq // => lt; rewrite !nth_mkseq //.
have Di : degree (iter i.+1 sigma y) = n by rewrite (degree_same (fconnect_iter _ _ _)).
have T : iter (q + (n - i.+1)) sigma (iter i.+1 sigma y) = pointed.
  by rewrite -iterD -addnA subnK // iterD -{1}D iter_degree.
by rewrite (letter_turn w T) Di.
Qed.

Definition scanned S f (y : W) := letters_of y == letters_from w n (odflt 0 (expected_percept b S f).2).

Theorem scanned_iff S r h v f (x : W) : embedded S r -> known S h -> follow S v h = Some f ->
  f.1 = 0 -> matches (seen_by w) scanned S x (h, v) f <-> x = phi r h.
Proof.
move=> I kh R f0; have [kf E] := follow_phi I kh R; rewrite /matches /scanned; set q := odflt 0 _.
have Bf : bearing (phi r f) = Some q.
  by have := expected_percept_phi I kf; rewrite /q /expected_percept f0 /= => -[_ <-].
have [c0 qE] : at_same_vertex (phi r f) pointed /\ findex sigma (phi r f) pointed = q.
  by move: Bf; rewrite /bearing; case: ifP => // c [].
have at_door : iter q sigma (phi r f) = pointed by rewrite -qE; exact: iter_findex.
have Dp : degree (@pointed W) = n by rewrite (degree_same (@pointed_at_v0 W)).
have Df : degree (phi r f) = n by rewrite -Dp -(degree_same c0).
have qn : q < n by rewrite -qE -Df; exact: findex_max.
split=> [/andP[lk /eqP Q]|->]; last first.
  by rewrite /looks /foretold /= (truth_matches I kh R) eqxx /= E (letters_at_v0 Df at_door) eqxx.
set y := walk v x in Q *; have Dy : degree y = n.
  by have := congr1 fst (looks_last I kh R lk); rewrite /= -/y Df.
have [Pr /allPn[l]] := adequate_word; rewrite /word => /(nthP 0)[i].
rewrite size_mkseq => lt; rewrite nth_mkseq // => <- nb.
have n0 : 0 < n by exact: degree_gt0.
pose c := (i + (n - q)) %% n; have cn : c < n by rewrite ltn_pmod.
have jn : n - c.+1 < n by rewrite ltn_subrL.
have J : at_v0 w pointed (iter (n - c.+1).+1 sigma y) != 0.
  have := congr1 (fun s => nth 0 s (n - c.+1)) Q; rewrite !nth_mkseq // => ->.
  by rewrite subnSK // subKn ?(ltnW cn) // modnDmr addnCA subnKC ?(ltnW qn) // modnDr modn_small.
have cy : at_same_vertex y pointed.
  apply: connect_trans (fconnect_iter _ (n - c.+1).+1 y) _; exact: not_blank_at_v0 J.
have qE' := letters_from_inj Pr qn _ (etrans (esym Q) (letters_at_v0 Dy (iter_findex cy))).
apply: (@walk_inj _ v); rewrite E; apply: (@iter_sigma_inj _ q); rewrite at_door {1}qE' ?iter_findex //.
by rewrite -Dy; exact: findex_max.
Qed.

(* ---- The program there ---- *)
Local Notation L := (scanning w n).

Lemma asks_letters k f (y : W) c d : bearing0 k = b -> f.1 = 0 ->
  degree y = degree_in (known_map k) f.1 -> due c d y -> exists c' z,
  makes (confirm L k f c) d (scanned (known_map k) f y, c') z (2 * n) /\ due c' z y.
Proof.
move=> kb f0 D du; have [z [A E]] := scan_makes n [::] du.
exists (opposite (degree_in (known_map k) f.1) n), z; split.
  rewrite /= kb -[2 * n]addn0; apply: (makes_bind A); exact: makes_return.
move: E; rewrite /due -D; case N : n (degree_gt0 v0) => [|i] //= _ ->.
exact: (opposite_turn i.+1).
Qed.

Lemma scanning_sets_out : exists k z,
  makes (set_out L (senses v0)) v0 k z (2 * n) /\ knows k (initial W) z.
Proof.
have [z [A E]] := scan_makes n [::] (erefl (iter 0 sigma v0)).
exists (knowledge_at_v0 n b 0), z; split; last first.
  split=> //; first exact: queue_initial.
  by move: E; rewrite /due iter_degree; case: (n) (degree_gt0 v0).
rewrite -[2 * n]addn0; apply: (makes_bind A); rewrite -/(letters_of v0).
have E0 : letters_of v0 = letters_from w n b.
  by apply: letters_at_v0 => //; exact: iter_findex (@pointed_at_v0 W).
have bn : b < n by exact: findex_max (@pointed_at_v0 W).
have H : has (fun q => letters_of v0 == letters_from w n q) (iota 0 n).
  by apply/hasP; exists b; rewrite ?mem_iota // E0.
have lt := H; rewrite has_find size_iota in lt; have := nth_find 0 H.
rewrite nth_iota // add0n => /eqP; rewrite {1}E0 => /(letters_from_inj (proj1 adequate_word) bn lt) <-.
exact: makes_return.
Qed.

Definition scanning_bound := 2 * n + (paper_bound (vertices W) (edges W) + 2 * n * edges W ^ 2).

Theorem scanning_correct pol budget : scanning_bound <= budget -> exists transcript answer z,
  [/\ episode (scanning_algorithm w pol) (rooted v0) senses budget = (transcript, Some answer, z),
      size transcript <= scanning_bound, valid answer & isomorphic (denote answer) (rooted z)].
Proof.
rewrite (chosen_episode (fun o => explorer_by (scanning w o.1) pol)); move: budget.
exact: (@explorer_by_correct W _ _ L pol senses scanned (2 * n) seen_by_percept (fun=> erefl) asks_letters
  scanned_iff (2 * n) scanning_sets_out).
Qed.
End InWorld.

(* one explorer for all worlds, and without a bound on their size *)
Theorem sufficient_iff_explored w : sufficient (at_v0 w) <->
  exists X : explorer (nat * nat) numbered_map, forall W : lighthouse_world,
  right denote X (rooted (@start W)) (percept_by (at_v0 w) (W := W)).
Proof.
split=> [/sensor_iff H|[X R] W V [B [Bo Bs Ba B0]]]; last first.
  by apply: (@twins_impossible _ _ denote X (rooted start) (rooted start)
    (percept_by (at_v0 w) (W := W)) (percept_by (at_v0 w) (W := V)) B) => //; exact: rooted_wellformed.
exists (scanning_algorithm w fifo) => W; have Ad := H _ (degree_gt0 (@start W)).
have [t [e [z [E _ V J]]]] := scanning_correct Ad fifo (leqnn _).
by exists (scanning_bound W), t, e, z; split=> //; exact: validP.
Qed.
