% READENDMARK  How a simulation ended.
%
% CALL: MARK = readEndMark (FOLDER)
%
%   FOLDER  folder of the run (text)
%   MARK    struct with code (exit status), seconds and reason ('finished',
%           'timeout', 'killed'); [] where the run has not ended, or where the
%           mark is not whole

function mark = readEndMark (folder)
  mark = [];
  fid = fopen (fullfile (folder, 'end.mark'), 'r');
  if fid < 0
    return
  end
  text = fread (fid, Inf, 'uint8=>char')';
  fclose (fid);
  t = regexp (text, '^(\d+) (\d+\.\d) (finished|timeout|killed)\n$', ...
              'tokens', 'once');
  if ~isempty (t)
    mark = struct ('code', str2double (t{1}), ...
                   'seconds', str2double (t{2}), 'reason', t{3});
  end
end

%!test
%! folder = tempname ();
%! mkdir (folder);
%! assert (isempty (readEndMark (folder)));
%! writeAtomic (fullfile (folder, 'end.mark'), "0 12.3 finished\n");
%! assert (readEndMark (folder).seconds, 12.3);
%! writeAtomic (fullfile (folder, 'end.mark'), '0 12.3 fini');
%! assert (isempty (readEndMark (folder)));
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (folder, 's');
