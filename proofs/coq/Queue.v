(* ---------------------------------------------------------------------------------------------
   U as a list: it is kept up to date by the two augmentations.         Algorithm 1, lines 19, 21

     queue_of S U         the list U holds the open darts of S, each once.
   --------------------------------------------------------------------------------------------- *)
From mathcomp Require Import all_ssreflect.
From Allworlds Require Import PartialMaps.
Set Implicit Arguments.
Unset Strict Implicit.
Unset Printing Implicit Defensive.

Definition queue_of S (U : seq dart) := uniq U /\ forall e, (e \in U) = is_open S e.

Lemma queue_initial k : queue_of (initial_map k) [seq (0, i) | i <- iota 0 k].
Proof.
split=> [|[v i]]; first by rewrite map_inj_uniq ?iota_uniq // => i j [].
rewrite /is_open andbT; apply/mapP/andP=> [[j]|[]]; first by rewrite mem_iota => /= lj [-> ->].
by case: v => //= _ li; exists i; rewrite ?mem_iota.
Qed.

Lemma queue_loop S U e h : queue_of S U ->
  queue_of (add_loop S e h) [seq x <- U | (x != e) && (x != h)].
Proof.
case=> Un mU; split=> [|x]; first exact: filter_uniq.
rewrite mem_filter mU /is_open /explored /= !inE !negb_or /known /=.
by rewrite -!andbA; do !case: (_ == _) => //=; rewrite ?andbF.
Qed.

Lemma queue_vertex S U e k : queue_of S U -> known S e -> (forall x, explored S x -> known S x) ->
  queue_of (add_vertex S e k)
    ([seq x <- U | x != e] ++ [seq (size (degrees S), i) | i <- iota 1 k.-1]).
Proof.
case=> Un mU ke lk; set n := size (degrees S).
have out i : ~~ known S (n, i) by rewrite /known ltnn.
split=> [|[v i]].
  rewrite cat_uniq filter_uniq // map_inj_uniq ?iota_uniq ?andbT /= => [|i j [] //].
  apply/hasPn=> x /mapP[i _ ->]; rewrite /= mem_filter mU /is_open.
  by rewrite (negbTE (out i)) !andbF.
rewrite mem_cat mem_filter mU /is_open /explored /= !inE !negb_or -/(explored S (v, i)).
case: (ltngtP v n) => [lv|gv|->].
- have nn j : ((v, i) == (n, j) :> dart) = false by rewrite xpair_eqE (ltn_eqF lv).
  have -> : (v, i) \in [seq (n, j) | j <- iota 1 k.-1] = false.
    by apply/mapP=> -[j _ /eqP]; rewrite nn.
  rewrite nn /known /degree_in /= size_rcons nth_rcons -/n lv (ltnW lv : v < n.+1) orbF /=.
  by rewrite andbCA.
- have -> : known (add_vertex S e k) (v, i) = false by rewrite /known /= size_rcons ltnS leqNgt gv.
  rewrite /known /= [v < n]ltnNge (ltnW gv) andbF /=; apply/mapP=> -[j _ [E]].
  by rewrite E ltnn in gv.
rewrite (negbTE (out i)) andbF /= /known /degree_in /= size_rcons nth_rcons -/n ltnn eqxx ltnSn /=.
have -> : (n, i) == e = false by apply/eqP=> E; move: (out i); rewrite E ke.
have -> : explored S (n, i) = false by apply/negP=> /lk; rewrite (negbTE (out i)).
rewrite xpair_eqE eqxx /= andbT.
apply/mapP/andP=> [[j]|[lk' i0]].
  rewrite mem_iota => /andP[j0 jk] [->]; rewrite -lt0n; split=> //.
  by case: k jk => [|k] //; rewrite ltnS leqNgt j0.
by exists i; rewrite // mem_iota lt0n i0; case: k lk'.
Qed.

