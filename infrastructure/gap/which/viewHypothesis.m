% VIEWHYPOTHESIS  Puts together what a hypothesis needs to be evaluated.
%
% CALL: VIEW = viewHypothesis (WHITE, H, PRIOR)
%
%   WHITE  struct of whitenEmulator;  H  struct of newHypothesis
%   PRIOR  struct mean, sd of the parameters, see unknownsOf
%   VIEW   struct white, h, unknowns
%
% See also: predictHypothesis, fitHypothesis, integrateEvidence

function view = viewHypothesis (white, h, prior)
  view = struct ('white', white, 'h', h, ...
                 'unknowns', unknownsOf (white, h, prior));
end

%!test
%! models = handMadeModels ();
%! view = viewHypothesis (models.white, newHypothesis ('null'), models.prior);
%! assert (numel (view.unknowns.lo), 1);
