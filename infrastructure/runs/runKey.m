% RUNKEY  Hash of everything that decides the result of a run.
%
% CALL: [KEY, OLDER, TEXT] = runKey (VARIABLES, EFFECTVARS, H)
%
%   VARIABLES   scalar struct, see runVariables
%   EFFECTVARS  cell of names of effect variables
%   H           scalar struct, one element of hashModels
%   KEY         64 hexadecimal digits
%   OLDER       1 x n cell, the keys that earlier versions gave to this run
%   TEXT        '|name=value' of each variable that counts, names sorted; KEY is
%               the hash of H.input and TEXT, so a record that holds both proves
%               them
%
% Numbers count with 15 digits, as they are written for the run (toDigits);
% earlier versions wrote 17.
%
% An effect variable with the value that data.head declares anyway does not
% count: a run of the plain model stays the same run when candidate effects
% are added to the case later.

function [key, older, text] = runKey (variables, effectVars, h)
  text = textOf (variables, effectVars, h, @toDigits);
  key = hash ('sha256', [h.input, text]);
  older = cell (1, 0);
  if ~isargout (2)                     % most of the time, for many runs
    return
  end
  texts = unique ({text, textOf(variables, effectVars, h, @(x) x)});
  inputs = [{h.input}, h.older];
  for input = inputs
    older = [older, strcat(input, texts)];
  end
  older = cellfun (@(text) hash ('sha256', text), ...
                   setdiff (older, [h.input, text]), 'UniformOutput', false);
end

function text = textOf (variables, effectVars, h, rounded)
  names = sort (fieldnames (variables));
  text = '';
  for k = 1:numel (names)
    name = names{k};
    value = rounded (variables.(name));
    isOff = any (strcmp (name, effectVars)) && ...
            isfield (h.defaults, name) && ...
            rounded (h.defaults.(name)) == value;
    if ~isOff
      text = [text, sprintf('|%s=%.17g', name, value)];
    end
  end
end

%!shared h, v
%! h = struct ('input', 'x', 'older', {{}}, 'defaults', struct ('e', 0));
%! v = struct ('a', 1, 'b', 2);
%!assert (numel (runKey (v, {}, h)), 64)
%!test
%! % neutral effect: the same run; the order of the variables does not count
%! w = struct ('b', 2, 'e', 0, 'a', 1);
%! assert (runKey (w, {'e'}, h), runKey (v, {}, h));
%! w.e = 1;
%! assert (! isequal (runKey (w, {'e'}, h), runKey (v, {}, h)));
%!test
%! w = v;
%! w.a = 1 + 1e-14;
%! assert (! isequal (runKey (w, {}, h), runKey (v, {}, h)));
%!test
%! % numbers of 17 digits: the run that an earlier version made is known
%! [key, older] = runKey (v, {}, h);
%! assert (older, cell (1, 0));
%! w = v;
%! w.a = 1 + eps;
%! [same, older] = runKey (w, {}, h);
%! assert (same, key);
%! assert (older, {hash('sha256', sprintf ('x|a=%.17g|b=2', 1 + eps))});
%! h.older = {'y'};
%! [~, older] = runKey (w, {}, h);
%! assert (numel (older), 3);
