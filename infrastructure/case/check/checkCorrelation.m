% CHECKCORRELATION  Checks the correlation of the measurement errors.
%
% CALL: P = checkCorrelation (OPTIM, SIZES)
%
%   OPTIM  scalar struct, the optim of loadInput
%   SIZES  1 x M, targets of each model; [] where they make no sense
%   P      1 x n faults, see checkFault
%
% optim.correlation{k}: a length in the unit of `at` (results.csv), one number
% or one a target (0 or NaN: independent), or 'estimate'; [] for none.
%
% Reasons: badCorrelation correlationCount

function p = checkCorrelation (optim, sizes)
  p = checkFault ();
  if ~isfield (optim, 'correlation') || ...
      checkIs ('nothing', optim.correlation)
    return
  end
  value = optim.correlation;
  field = 'optim.correlation';
  cure = ['Write optim.correlation{1} = 2; (errors of model 1 are alike ' ...
          'over 2 units of at), or = ''estimate'';'];
  if ~iscell (value) || ~isvector (value)
    p = checkFault ('badCorrelation', field, 'a cell, one length a model', ...
                    checkShow (value), cure);
    return
  end
  for k = find (~cellfun (@isLength, value(:)'))
    p(end + 1) = checkFault ('badCorrelation', ...
                             sprintf ('%s{%d}', field, k), ...
                             ['finite numbers from 0 (NaN: ' ...
                              'independent), or ''estimate'''], ...
                             checkShow (value{k}), cure);
  end
  if isempty (p) && ~isempty (sizes)
    p = checkCount (value(:)', sizes, field, cure);
  end
end

function yes = isLength (v)
  yes = isequal (v, []) || isequal (v, 'estimate') || ...
        (checkIs ('vector', v) && all (isnan (v) | (v >= 0 & isfinite (v))));
end

function p = checkCount (value, sizes, field, cure)
  p = checkFault ();
  given = cellfun (@numel, value);
  given(cellfun (@ischar, value)) = 1;
  n = numel (given);
  if n > numel (sizes) || any (given > 1 & given ~= sizes(1:n))
    p = checkFault ('correlationCount', field, ...
                    sprintf (['at most %d cell(s), in each one length or ' ...
                              'as many as targets: %s'], numel (sizes), ...
                             checkShow (sizes)), checkShow (given), cure);
  end
end

%!test
%! check = @(c) checkCorrelation (struct ('correlation', {c}), [3, 1]);
%! for good = {{2, 'estimate'}, {[], 0}, {[1, NaN, 0]}}
%!   assert (isempty (check (good{1})));
%! end
%! assert (check ({2, 'guess'}).id, 'DEcalioc:checkCase:badCorrelation');
%! assert (check ({[1, 2]}).id, 'DEcalioc:checkCase:correlationCount');
