% READENDMARK  How a simulation ended.
%
% CALL: MARK = readEndMark (FOLDER)
%
%   FOLDER  folder of the run (text)
%   MARK    struct with code (exit status), seconds and reason ('finished',
%           'timeout', 'killed' from outside); [] where the run has not ended,
%           or where the mark is not whole

function mark = readEndMark (folder)
  mark = [];
  text = checkReadText ([folder, '/end.mark']);
  t = regexp (text, '^(\d+) (\d+\.\d) (finished|timeout|killed)\n$', ...
              'tokens', 'once');
  if ~isempty (t)
    mark = struct ('code', str2double (t{1}), ...
                   'seconds', str2double (t{2}), 'reason', t{3});
    % by HUP, INT, KILL or TERM. A crash (SEGV, ABRT, FPE) is the program's own
    % and would come again with the same seed
    if any (mark.code == 128 + [1, 2, 9, 15]) && strcmp (t{3}, 'finished')
      mark.reason = 'killed';
    end
  end
end

%!test
%! folder = emptyFolder ();
%! assert (isempty (readEndMark (folder)));
%! for text = {"0 12.3 finished\n", '0 12.3 fini'}
%!   writeAtomic (fullfile (folder, 'end.mark'), text{1});
%!   assert (isempty (readEndMark (folder)), text{1}(end) ~= "\n");
%! end
%! writeAtomic (fullfile (folder, 'end.mark'), "143 12.3 killed\n");
%! assert (readEndMark (folder), ...
%!         struct ('code', 143, 'seconds', 12.3, 'reason', 'killed'));

% SPDX-License-Identifier: GPL-3.0-only
