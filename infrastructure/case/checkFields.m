% CHECKFIELDS  Finds fields of a struct that nobody reads: misspelt ones.
%
% CALL: P = checkFields (S, PREFIX, KNOWN)
%
%   S       scalar struct
%   PREFIX  how the user writes it, e.g. 'Input' (text)
%   KNOWN   cell of the names of all fields that are read
%   P       1 x n faults, see checkFault
%
% See also: checkCase, checkNearest

function p = checkFields (s, prefix, known)
  p = checkFault ();
  unknown = fieldnames (s)';
  unknown = unknown(~ismember (unknown, known));
  for k = 1:numel (unknown)
    cure = checkNearest (unknown{k}, known);
    if isempty (cure)
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
