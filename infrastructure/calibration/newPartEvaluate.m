% NEWPARTEVALUATE  Makes the function that runs some models of a case alone.
%
% CALL: EVALUATE = newPartEvaluate (CASE, IS, SAY)
%
%   CASE      see newCase;  IS  1 x M logical, the models that run
%   EVALUATE  as of newEvaluate, Z and the seconds of the budget still those of
%             the whole case: NaN for targets of the other models
%
% See also: completePlan, diagnoseCase

function evaluate = newPartEvaluate (Case, is, say)
  own = is([Case.targets.model]);
  number = num2cell (cumsum (is)([Case.targets(own).model]));
  Case.models = Case.models(is);
  Case.targets = Case.targets(own);
  [Case.targets.model] = number{:};
  part = newEvaluate (Case, say);
  evaluate = @(varargin) inColumns (part, is, own, varargin{:});
end

function [Z, budget] = inColumns (part, is, own, varargin)
  seconds = varargin{end}.seconds;
  varargin{end}.seconds = seconds(is);
  [found, budget] = part (varargin{:});
  seconds(is) = budget.seconds;
  budget.seconds = seconds;
  Z = NaN (rows (found), numel (own));
  Z(:, own) = found;
end

%!test
%! % the second of two models
%! Case = newCase (standInCase (tempname ()));
%! [~, budget] = newEvaluate (Case, @(text) []);
%! evaluate = newPartEvaluate (Case, [false, true], @(text) []);
%! [Z, budget] = evaluate ([1, 2; 3, 4], [], 1, 'plan', budget);
%! assert (Z, [NaN, NaN, -1; NaN, NaN, -1], 1e-12);
%! assert (budget.new, 2);
%! assert (cellfun (@numel, budget.seconds), [0, 2]);
%! assert (isempty (listRunFolders (Case.store, 'First')));
%! % what the whole case runs then finds them
%! whole = newEvaluate (Case, @(text) []);
%! [Z, budget] = whole ([1, 2; 3, 4], [], 1, 'plan', budget);
%! assert (Z, [3, 2, -1; 7, 12, -1], 1e-12);
%! assert ([budget.new, budget.reused], [4, 2]);
