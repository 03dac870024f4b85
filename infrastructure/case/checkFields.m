% CHECKFIELDS  Finds fields of a struct that nobody reads: misspelt ones.
%
% CALL: P = checkFields (S, PREFIX, KNOWN)
%       [P, OWN] = checkFields (S, PREFIX, KNOWN)
%
%   S       scalar struct
%   PREFIX  how the user writes it, e.g. 'Input' (text)
%   KNOWN   cell of the names of all fields that are read
%   P       1 x n faults, see checkFault
%   OWN     1 x m cell of the names that are near none of KNOWN, which a file of
%           the user may read; asked for, they are no faults
%
% See also: checkCase, checkNearest

function [p, own] = checkFields (s, prefix, known)
  p = checkFault ();
  own = cell (1, 0);
  unknown = fieldnames (s)';
  unknown = unknown(~ismember (unknown, known));
  for k = 1:numel (unknown)
    cure = checkNearest (unknown{k}, known);
    if isempty (cure) && nargout > 1
      own = [own, unknown(k)];
      continue
    elseif isempty (cure)
      cure = 'Take it out; docs/inputs.md lists all fields.';
    end
    p(end + 1) = checkFault ('unknownField', ...
                             [prefix, '.', unknown{k}], ...
                             sprintf ('one of the fields of %s', prefix), ...
                             'a field that nothing reads', cure);
  end
end

%!assert (isempty (checkFields (struct ('a', 1), 'Input', {'a', 'b'})))
%!test
%! p = checkFields (struct ('sed', 1), 'Input', {'cpu', 'seed'});
%! assert (p.id, 'DEcalioc:checkCase:unknownField');
%! assert (! isempty (strfind (p.message, 'Did you mean seed?')));
%!test
%! % a field of the user's own is a fault only where it may not be there
%! s = struct ('sed', 1, 'colour', 2);
%! assert (numel (checkFields (s, 'Input', {'cpu', 'seed'})), 2);
%! [p, own] = checkFields (s, 'Input', {'cpu', 'seed'});
%! assert (numel (p), 1);
%! assert (own, {'colour'});
