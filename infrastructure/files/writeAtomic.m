% WRITEATOMIC  Writes a text file so that it is there whole or not at all.
%
% CALL: writeAtomic (FILE, TEXT)
%
%   FILE  path of the file (text); an older file of that name is replaced
%   TEXT  content (char)
%
% The text goes to a file beside it first, which then takes the name.
%
% Errors: DEcalioc:writeAtomic:cannotWrite (full disk, read-only folder)
%
% See also: readRecord, failedRecord

function writeAtomic (file, text)
  draft = sprintf ('%s.%d.tmp', file, getpid ());
  [fid, why] = fopen (draft, 'w');
  if fid < 0
    refuse (file, why);
  end
  done = fwrite (fid, text) == numel (text);
  done = fflush (fid) == 0 && done;
  done = fclose (fid) == 0 && done;
  if ~done
    [~, ~] = unlink (draft);
    refuse (file, 'the text could not be written; is the disk full?');
  end
  [err, why] = rename (draft, file);
  if err ~= 0
    [~, ~] = unlink (draft);
    refuse (file, why);
  end
end

function refuse (file, why)
  error ('DEcalioc:writeAtomic:cannotWrite', ...
         ['writeAtomic: %s must be writable, got: %s. Free some space or ' ...
          'correct the permissions and start again; finished runs are ' ...
          'kept.'], file, why);
end

%!test
%! file = tempname ();
%! writeAtomic (file, "one\ntwo\n");
%! assert (fileread (file), "one\ntwo\n");
%! writeAtomic (file, 'three');
%! assert (fileread (file), 'three');
%! assert (isempty (glob ([file, '.*'])));
%! unlink (file);
%!error id=DEcalioc:writeAtomic:cannotWrite writeAtomic ('/nowhere/x', 'a')
