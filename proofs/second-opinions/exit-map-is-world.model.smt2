; A model of the hypotheses of exit-map-is-world.smt2
; Says: The world is a triangle: v0 with darts a0 a1, v1 with b0 b1, v2 with c0 c1; edges a0b0,
;   a1c0, b1c1. S knows all of it.
; Expected: sat

(set-logic ALL)
(declare-datatypes ((Dart 0)) (((a0) (a1) (b0) (b1) (c0) (c1))))
(declare-datatypes ((MapDart 0)) (((A0) (A1) (B0) (B1) (C0) (C1))))
(define-fun sigma ((x Dart)) Dart
  (ite (= x a0) a1 (ite (= x a1) a0 (ite (= x b0) b1 (ite (= x b1) b0 (ite (= x c0) c1 c0))))))
(define-fun alpha ((x Dart)) Dart
  (ite (= x a0) b0 (ite (= x a1) c0 (ite (= x b0) a0 (ite (= x b1) c1 (ite (= x c0) a1 b1))))))
(define-fun seen ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun walked ((x Dart)) Bool (or (= x a0) (= x a1) (= x b0) (= x b1) (= x c0) (= x c1)))
(define-fun known ((x MapDart)) Bool (or (= x A0) (= x A1) (= x B0) (= x B1) (= x C0) (= x C1)))
(define-fun explored ((x MapDart)) Bool
  (or (= x A0) (= x A1) (= x B0) (= x B1) (= x C0) (= x C1)))
(define-fun open ((x MapDart)) Bool false)
(define-fun phi ((x MapDart)) Dart
  (ite (= x A0) a0 (ite (= x A1) a1 (ite (= x B0) b0 (ite (= x B1) b1 (ite (= x C0) c0 c1))))))
(define-fun name ((x Dart)) MapDart
  (ite (= x a0) A0 (ite (= x a1) A1 (ite (= x b0) B0 (ite (= x b1) B1 (ite (= x c0) C0 C1))))))
(define-fun next ((x MapDart)) MapDart
  (ite (= x A0) A1 (ite (= x A1) A0 (ite (= x B0) B1 (ite (= x B1) B0 (ite (= x C0) C1 C0))))))
(define-fun partner ((x MapDart)) MapDart
  (ite (= x A0) B0 (ite (= x A1) C0 (ite (= x B0) A0 (ite (= x B1) C1 (ite (= x C0) A1 B1))))))
(define-fun start () Dart a0)
(define-fun root () MapDart A0)

(assert (=>
  (and (seen start) (forall ((d Dart)) (=> (seen d) (and (seen (sigma d)) (seen (alpha d))))))
  (forall ((d Dart)) (seen d))))
(assert (forall ((x MapDart)) (=> (known x) (and (seen (phi x)) (= (name (phi x)) x)))))
(assert (forall ((d Dart)) (=> (seen d) (and (known (name d)) (= (phi (name d)) d)))))
(assert (forall ((x MapDart))
  (=> (known x) (and (known (next x)) (= (phi (next x)) (sigma (phi x)))))))
(assert (forall ((x MapDart)) (=> (explored x) (and (known x) (walked (phi x))))))
(assert (forall ((x MapDart)) (=> (and (known x) (walked (phi x))) (explored x))))
(assert (forall ((x MapDart))
  (=> (explored x)
      (and (explored (partner x)) (= (partner (partner x)) x)
           (= (phi (partner x)) (alpha (phi x)))))))
(assert (known root))
(assert (= (phi root) start))
(assert (forall ((d Dart)) (=> (and (seen d) (not (walked d))) (open (name d)))))
(assert (forall ((x MapDart)) (not (open x))))
(check-sat)
