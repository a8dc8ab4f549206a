(* Fifo.v -- 'opens' is a first-in-first-out queue: new darts go to the end, clockwise; links take out their two darts *)
Set Warnings "-notation-overridden".
From mathcomp Require Import all_ssreflect.
From Allworlds Require Rooted.
From Allworlds Require Import Lighthouse Algorithm Refine.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.
Lemma opensE S : opens S = [seq e <- darts S | isopen S e].
Proof. by rewrite /opens undup_id // darts_uniq. Qed.
Lemma fifo_first k : opens (State [:: k] [::]) = [seq (0, i) | i <- iota 0 k].
Proof.
rewrite opensE /darts /= cats0 /deg /=; apply/all_filterP/allP=> e /mapP[i]; rewrite mem_iota /= => li ->.
by rewrite /isopen /known /deg /= li.
Qed.
Lemma fifo_loop S e h : isopen S e -> isopen S h -> opens (add_loop S e h) = [seq x <- opens S | (x != e) && (x != h)].
Proof.
move=> oe oh; rewrite !opensE -filter_predI; apply: eq_filter => x /=.
rewrite /isopen /linked /= !inE !negb_or /known /=; case: (x == e) => /=; rewrite ?andbF //.
by case: (x == h); rewrite /= ?andbF.
Qed.
Lemma fifo_vertex S e k : isopen S e -> 0 < k -> (forall x, linked S x -> known S x) ->
  opens (add_vertex S e k) = [seq x <- opens S | x != e] ++ [seq (size (degs S), i) | i <- iota 1 k.-1].
Proof.
move=> oe k0 lk; have [ke _] := andP oe; set n := size (degs S); set S' := add_vertex S e k.
have ef : e != fresh S by apply/eqP=> E; move: (fresh_unknown S); rewrite -E ke.
have -> : opens S' = [seq x <- darts S ++ [seq (n, i) | i <- iota 0 k] | isopen S' x].
  rewrite opensE /darts size_rcons -/n -addn1 iotaD map_cat flatten_cat add0n /= cats0; congr (filter _ (flatten _ ++ _)).
    apply/eq_in_map => v; rewrite mem_iota /= => lv; by rewrite /deg nth_rcons lv.
  by rewrite /deg nth_rcons ltnn eqxx.
rewrite filter_cat; congr (_ ++ _).
  rewrite opensE -filter_predI; apply: eq_in_filter => x; rewrite mem_darts => kx /=.
  rewrite /isopen known_rcons // kx /linked /= !inE !negb_or.
  by have -> : x != fresh S by apply/eqP=> E; move: (fresh_unknown S); rewrite -E kx.
case: k k0 @S' => // k _ S' /=; have -> : isopen S' (n, 0) = false.
  by rewrite /isopen /linked /= !inE /fresh -/n eqxx orbT andbF.
apply/all_filterP/allP=> x /mapP[i]; rewrite mem_iota => /andP[i0 ik] ->.
rewrite /isopen /known /= size_rcons ltnSn /deg nth_rcons ltnn eqxx add1n in ik *; rewrite ik /=.
apply/negP; rewrite /linked /= !inE => /or3P[/eqP E|/eqP[E]|/lk/andP[]]; last by rewrite ltnn.
  by move: (fresh_unknown S); case/andP: ke; rewrite -E /= ltnn.
by rewrite E in i0.
Qed.
